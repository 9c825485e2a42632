/** One model through the command line onto sheets, read back from the SVG and from the PDF. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { foldwright, inFolder, type Ended } from './command.js';
import { parseFold, type FoldFile } from './fold-file.js';
import { checkGuides } from './guide-check.js';
import { readPdf } from './pdf-file.js';
import { checkSheets, type IdsReport } from './sheet-check.js';
import { readSheet, type SheetFile } from './sheet-file.js';

export interface PrintReport {
  model: { faces: number };
  pieces: object[];
  sheets: number;
  ids: IdsReport;
  flaps: { wanted: number; full: number; shrunk: number; strips: number; taped: number };
  notices: { code: string; text: string }[];
  seconds: { total: number };
}

export interface PrintedRun {
  ended: Ended;
  /** By format; the sources of the SVG files beside them. */
  svg: SheetFile[];
  pdf: SheetFile[];
  sources: string[];
  fold: FoldFile;
  report: PrintReport;
}

/** @throws if the run fails */
export function printedRun(model: string, args: string[]): Promise<PrintedRun> {
  return inFolder(async (folder) => {
    const path = (name: string): string => join(folder, name);
    const names = ['out.svg', 'out.pdf', 'out.fold'].flatMap((name) => ['-o', path(name)]);
    const all = [model, ...names, '--report', path('r.json'), '--quiet', ...args];
    const ended = await foldwright(all);
    if (ended.status !== 0) throw new Error(`ended with ${ended.status}: ${ended.stderr}`);
    const sources = readdirSync(folder)
      .filter((name) => name.endsWith('.svg'))
      .map((name) => readFileSync(path(name), 'utf8'));
    const { pages } = await readPdf(new Uint8Array(readFileSync(path('out.pdf'))));
    return {
      ended,
      sources,
      svg: sources.map(readSheet),
      pdf: pages.map(({ sheet }) => sheet),
      fold: parseFold(readFileSync(path('out.fold'), 'utf8')),
      report: JSON.parse(readFileSync(path('r.json'), 'utf8')) as PrintReport,
    };
  });
}

/** Everything that is wrong with the sheets of a run, in either format. */
export function faultsOf({ svg, pdf, fold, report }: PrintedRun, margin: number): string[] {
  const formats = { svg, pdf };
  return Object.entries(formats).flatMap(([format, sheets]) =>
    [...checkSheets(sheets, fold, report.ids, margin), ...checkGuides(sheets, margin)].map(
      (fault) => `${format}: ${fault}`,
    ),
  );
}
