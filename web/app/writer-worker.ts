/** Entry of the worker that writes a result: the sheets for the screen, and files to keep. */
import { buffersOf } from '../core/transfer.js';
import type { ExportFormat } from '../export/formats.js';
import { preparePrint, type Print } from '../export/print.js';
import { writeSvg } from '../export/svg.js';
import type { JobResult, Notice } from '../model/job.js';
import type { PrintOptions } from '../model/print-options.js';
import { exportResult, type ExportedFile } from './exporters.js';
import { loadFont } from '../browser/font-loader.js';

/** What is written. */
export interface WriterSource {
  result: JobResult;
  /** Name of the model without its ending. */
  name: string;
  /** Margin of the sheets in mm. */
  margin: number;
}

/** Comes first, with the result that all orders are about. */
export interface WriterInput {
  type: 'input';
  source: WriterSource;
}

/** Comes with a port for the answer, and with how the sheets shall look. */
export type WriterOrder = { options: PrintOptions } & (
  | /** One sheet as SVG, counted from 0. Answered by its text. */
    { type: 'sheet'; sheet: number }
    /** All sheets in a format: pdf, svg, fold or glb. Answered by an `ExportedFile`. */
  | { type: 'file'; format: ExportFormat }
  /** What a person should know of the sheets. Answered by a list of `Notice`. */
  | { type: 'notices' }
);

export type WriterAnswer<Content> =
  | { type: 'written'; content: Content }
  /** `reason` is for those who look for the fault. */
  | { type: 'failed'; reason: string };

let source: WriterSource | null = null;

/** The sheets as they were drawn last: most orders ask for the same look again. */
let last: { key: string; print: Promise<Print> } | null = null;

function printOf(from: WriterSource, options: PrintOptions): Promise<Print> {
  const key = JSON.stringify(options);
  if (last?.key !== key) {
    const { result, name, margin } = from;
    last = { key, print: preparePrint({ result, title: name, margin, options, loadFont }) };
  }
  return last.print;
}

type Content = string | ExportedFile | Notice[];

async function write(order: WriterOrder): Promise<Content> {
  if (!source) throw new Error('The result must come first');
  const print = await printOf(source, order.options);
  if (order.type === 'sheet') return writeSvg(print, order.sheet);
  if (order.type === 'notices') return print.notices;
  return exportResult(order.format, { result: source.result, name: source.name, print });
}

async function answer(order: WriterOrder): Promise<WriterAnswer<Content>> {
  try {
    return { type: 'written', content: await write(order) };
  } catch (error) {
    return { type: 'failed', reason: String(error) };
  }
}

addEventListener('message', ({ data, ports }: MessageEvent<WriterInput | WriterOrder>) => {
  if (data.type === 'input') source = data.source;
  else void answer(data).then((said) => ports[0]?.postMessage(said, buffersOf(said)));
});
