/** Entry of the worker that writes a result: the sheets for the screen, and files to keep. */
import { buffersOf } from '../core/transfer.js';
import { writeSvg } from '../export/svg.js';
import { exportResult, type ExportedFile, type ExportInput } from './exporters.js';

/** Comes first, with the result that all orders are about. */
export interface WriterInput {
  type: 'input';
  input: ExportInput;
}

/** Comes with a port for the answer. */
export type WriterOrder =
  /** One sheet as SVG, counted from 0. Answered by its text. */
  | { type: 'sheet'; sheet: number }
  /** All sheets in a format: pdf, svg, fold or glb. Answered by an `ExportedFile`. */
  | { type: 'file'; format: string };

export type WriterAnswer<Content> =
  | { type: 'written'; content: Content }
  /** `reason` is for those who look for the fault. */
  | { type: 'failed'; reason: string };

let input: ExportInput | null = null;

function write(order: WriterOrder): string | Promise<ExportedFile> {
  if (!input) throw new Error('The result must come first');
  return order.type === 'sheet'
    ? writeSvg(input.result, order.sheet)
    : exportResult(order.format, input);
}

async function answer(order: WriterOrder): Promise<WriterAnswer<string | ExportedFile>> {
  try {
    return { type: 'written', content: await write(order) };
  } catch (error) {
    return { type: 'failed', reason: String(error) };
  }
}

addEventListener('message', ({ data, ports }: MessageEvent<WriterInput | WriterOrder>) => {
  if (data.type === 'input') input = data.input;
  else void answer(data).then((said) => ports[0]?.postMessage(said, buffersOf(said)));
});
