/** Entry of the worker that writes a result: the sheets for the screen, and files to keep. */
import { buffersOf } from '../core/transfer.js';
import type { DrawnFormat } from '../export/formats.js';
import { preparePrint, type Print } from '../export/print.js';
import { printedPages, type PrintedPage } from '../export/printed-pages.js';
import { writeSvg } from '../export/svg.js';
import type { JobResult, Notice } from '../model/job.js';
import type { SheetRange } from '../model/sheet-range.js';
import type { PrintOptions } from '../model/print-options.js';
import { exportResult, type ExportedFile } from './exporters.js';
import { assetLoader, type AssetAddresses, type AssetLoader } from '../browser/asset-loader.js';

/** What is written. */
export interface WriterSource {
  result: JobResult;
  /** Name of the model without its ending. */
  name: string;
  /** Margin of the sheets in mm. */
  margin: number;
}

/** What is asked about a result, and how its sheets shall look. */
export type WriterOrder = { options: PrintOptions } & (
  | /** One sheet as SVG, counted from 0. Answered by its text. */
    { type: 'sheet'; sheet: number }
    /** The sheets that are wanted in a format. Answered by an `ExportedFile`. */
  | { type: 'file'; format: DrawnFormat; only: SheetRange }
  /** All pages as they are printed. Answered by a list of `PrintedPage`. */
  | { type: 'pages' }
  /** What a person should know of the sheets. Answered by a list of `Notice`. */
  | { type: 'notices' }
);

export type WriterMessage =
  /** The first one: where the worker finds fonts and renderers. */
  | { type: 'begin'; assets: AssetAddresses }
  /** A result to be written, under a number of its own. */
  | { type: 'result'; result: number; source: WriterSource }
  /** Comes with a port for the answer. */
  | { type: 'order'; result: number; order: WriterOrder }
  | { type: 'forget'; result: number };

export type WriterAnswer<Content> =
  | { type: 'written'; content: Content }
  /** `reason` is for those who look for the fault. */
  | { type: 'failed'; reason: string };

interface Written {
  source: WriterSource;
  /** The sheets as they were drawn last: most orders ask for the same look again. */
  last: { key: string; print: Promise<Print> } | null;
}

const results = new Map<number, Written>();
let loader: AssetLoader | null = null;

function printOf(written: Written, options: PrintOptions): Promise<Print> {
  const key = JSON.stringify(options);
  if (written.last?.key !== key) {
    const { result, name, margin } = written.source;
    const print = preparePrint({ result, title: name, margin, options, ...loader! });
    written.last = { key, print };
  }
  return written.last.print;
}

/** As sharp as sheets are seen on a page. */
const previewDpi = 100;

/** The pages that tell how to build the model, and fine pictures, are in files only: a preview does not wait for them. */
function previewed(options: PrintOptions): PrintOptions {
  return { ...options, assembly: false, dpi: previewDpi };
}

type Content = string | ExportedFile | Notice[] | PrintedPage[];

async function write(written: Written | undefined, order: WriterOrder): Promise<Content> {
  if (!written) throw new Error('The result must come first');
  const isForPaper = order.type === 'file' || order.type === 'pages';
  const print = await printOf(written, isForPaper ? order.options : previewed(order.options));
  if (order.type === 'sheet') return writeSvg(print, order.sheet);
  if (order.type === 'notices') return print.notices;
  if (order.type === 'pages') return printedPages(print);
  const { result, name } = written.source;
  return exportResult(order.format, { result, name, print, only: order.only });
}

async function answer(
  written: Written | undefined,
  order: WriterOrder,
): Promise<WriterAnswer<Content>> {
  try {
    return { type: 'written', content: await write(written, order) };
  } catch (error) {
    return { type: 'failed', reason: String(error) };
  }
}

addEventListener('message', ({ data, ports }: MessageEvent<WriterMessage>) => {
  switch (data.type) {
    case 'begin':
      loader = assetLoader(data.assets);
      break;
    case 'result':
      results.set(data.result, { source: data.source, last: null });
      break;
    case 'order':
      void answer(results.get(data.result), data.order).then((said) =>
        ports[0]?.postMessage(said, buffersOf(said)),
      );
      break;
    case 'forget':
      results.delete(data.result);
      break;
  }
});
