import { strFromU8, unzipSync } from 'fflate';
import { expect, it } from 'vitest';
import { sheetName } from '../../web/export/sheet-name.js';
import { writeSvg } from '../../web/export/svg.js';
import { writeSvgZip } from '../../web/export/svg-zip.js';
import { boxAndLidResult } from './fixtures.js';
import { printOf } from './printed.js';

it('packs every sheet under its number', async () => {
  const print = await printOf(boxAndLidResult());
  const files = unzipSync(writeSvgZip(print, 'box.svg'));
  expect(Object.keys(files)).toEqual(['box-1.svg', 'box-2.svg']);
  expect(strFromU8(files['box-2.svg']!)).toBe(writeSvg(print, 1));
});

it('gives the same bytes every time', async () => {
  const write = async () => writeSvgZip(await printOf(boxAndLidResult()), 'a.svg');
  expect(await write()).toEqual(await write());
});

it('numbers sheets only where there are several', () => {
  expect(sheetName('dir.d/out.svg', 0, 1)).toBe('dir.d/out.svg');
  expect(sheetName('dir.d/out.svg', 1, 2)).toBe('dir.d/out-2.svg');
});
