import { expect, test } from 'vitest';
import { paperRules, pictureAddress } from '../../web/app/print-document.js';

const svg =
  '<svg xmlns="http://www.w3.org/2000/svg" width="10mm"><text>Wing #1, 50 % &amp; ü</text></svg>';

test('each size of paper has a page of its own, without margins', () => {
  const rules = paperRules([
    { width: 210, height: 297 },
    { width: 297, height: 210 },
    { width: 210, height: 297 },
    { width: 215.9, height: 279.4 },
  ]);
  const pages = [...rules.matchAll(/@page ([\w-]+) \{ size: ([^;]+); margin: 0 \}/g)];
  expect(pages.map(([, name, size]) => [name, size])).toEqual([
    ['paper-210x297', '210mm 297mm'],
    ['paper-297x210', '297mm 210mm'],
    ['paper-215_9x279_4', '215.9mm 279.4mm'],
  ]);
  // For browsers without names of pages: the first one.
  expect(rules).toMatch(/^@page \{ size: 210mm 297mm; margin: 0 \}/);
});

test('the address of a picture holds it to the letter', () => {
  const address = pictureAddress({ svg });
  expect(decodeURIComponent(address.slice(address.indexOf(',') + 1))).toBe(svg);
});
