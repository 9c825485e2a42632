/** Pages as a printer takes them, and files of some sheets only. */
import { expect, test } from 'vitest';
import { writeFiles } from '../../web/export/files.js';
import { pagesOf } from '../../web/export/print.js';
import { printedPages } from '../../web/export/printed-pages.js';
import { writeSvg } from '../../web/export/svg.js';
import type { JobResult } from '../../web/model/job.js';
import { boxAndLidResult } from './fixtures.js';
import { readPdf } from './pdf-file.js';
import { printOf } from './printed.js';

/** The box, its lid, and the lid once more, each on a sheet of its own. */
function threeSheets(): JobResult {
  const result = boxAndLidResult();
  const [box, lid] = result.pieces;
  const pieces = [box!, lid!, { ...lid!, name: 'C' }].map((piece, sheet) => ({ ...piece, sheet }));
  return { ...result, pieces, sheets: pieces.map(() => ({ ...result.sheets[0]! })) };
}

test('pages are the SVG that is saved, and the first ones tell how to build the model', async () => {
  const print = await printOf(boxAndLidResult(), { options: { assembly: true } });
  const pages = printedPages(print);
  const guides = print.pages.map((_, page) => writeSvg(pagesOf(print), page));
  const sheets = print.sheets.map((_, sheet) => writeSvg(print, sheet));
  expect(guides.length).toBeGreaterThan(0);
  expect(pages.map(({ svg }) => svg)).toEqual([...guides, ...sheets]);
  expect(pages.map(({ sheet }) => sheet)).toEqual([...guides.map(() => null), ...sheets.keys()]);
  const { width, height } = print.sheets[0]!;
  expect(pages.at(-1)).toMatchObject({ width, height });
});

test('on both sides each sheet has its back behind it', async () => {
  const print = await printOf(threeSheets(), { options: { duplex: true } });
  const pages = printedPages(print);
  expect(pages.map(({ sheet }) => sheet)).toEqual([0, 0, 1, 1, 2, 2]);
  expect(pages[1]!.svg).toBe(writeSvg({ ...print, sheets: print.backs }, 0));
});

test('files of some sheets hold these alone, under their numbers', async () => {
  const result = threeSheets();
  const print = await printOf(result, { options: { assembly: true } });
  const write = (format: 'svg' | 'dxf' | 'pdf', only: readonly number[] | null) =>
    writeFiles(format, { result, print, name: `box.${format}`, only });
  const names = async (...args: Parameters<typeof write>) =>
    (await write(...args)).map(({ name }) => name);
  expect(await names('svg', [0, 2])).toEqual(['box-1.svg', 'box-3.svg']);
  expect(await names('dxf', [1])).toEqual(['box-2.dxf']);
  expect((await names('svg', null)).slice(0, 3)).toEqual(['box-1.svg', 'box-2.svg', 'box-3.svg']);
  const [chosen] = await write('pdf', [1, 2]);
  const [all] = await write('pdf', null);
  const texts = async (bytes: Uint8Array) =>
    (await readPdf(bytes)).pages.map(({ sheet }) => sheet.pieces.size);
  expect(await texts(chosen!.bytes)).toHaveLength(2);
  expect(await texts(all!.bytes)).toHaveLength(print.pages.length + 3);
});
