import { strFromU8, unzipSync } from 'fflate';
import { expect, it } from 'vitest';
import { sheetName } from '../../web/export/sheet-name.js';
import { writeSvg } from '../../web/export/svg.js';
import { writeSvgZip } from '../../web/export/svg-zip.js';
import { boxAndLidResult } from './fixtures.js';

it('packs every sheet under its number', () => {
  const result = boxAndLidResult();
  const files = unzipSync(writeSvgZip(result, 'box.svg'));
  expect(Object.keys(files)).toEqual(['box-1.svg', 'box-2.svg']);
  expect(strFromU8(files['box-2.svg']!)).toBe(writeSvg(result, 1));
});

it('gives the same bytes every time', () => {
  expect(writeSvgZip(boxAndLidResult(), 'a.svg')).toEqual(writeSvgZip(boxAndLidResult(), 'a.svg'));
});

it('numbers sheets only where there are several', () => {
  expect(sheetName('dir.d/out.svg', 0, 1)).toBe('dir.d/out.svg');
  expect(sheetName('dir.d/out.svg', 1, 2)).toBe('dir.d/out-2.svg');
});
