import { strFromU8, unzipSync } from 'fflate';
import { expect, it } from 'vitest';
import { writeFiles } from '../../web/export/files.js';
import { sheetName } from '../../web/export/sheet-name.js';
import { writeSvg } from '../../web/export/svg.js';
import { zipped } from '../../web/export/zip.js';
import { boxAndLidResult } from './fixtures.js';
import { printOf } from './printed.js';

async function archive(): Promise<Uint8Array> {
  const result = boxAndLidResult();
  const print = await printOf(result);
  return zipped(await writeFiles('svg', { result, print, name: 'box.svg' }));
}

it('packs every sheet under its number', async () => {
  const files = unzipSync(await archive());
  expect(Object.keys(files)).toEqual(['box-1.svg', 'box-2.svg']);
  const print = await printOf(boxAndLidResult());
  expect(strFromU8(files['box-2.svg']!)).toBe(writeSvg(print, 1));
});

it('gives the same bytes every time', async () => {
  expect(await archive()).toEqual(await archive());
});

it('numbers sheets only where there are several', () => {
  expect(sheetName('dir.d/out.svg', 0, 1)).toBe('dir.d/out.svg');
  expect(sheetName('dir.d/out.svg', 1, 2)).toBe('dir.d/out-2.svg');
});
