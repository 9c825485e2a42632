import { extentsOf } from '../model/bounds.js';
import type { JobResult, Model } from '../model/job.js';
import { count } from './numbers.js';

/** Below so many mm a length is told to a tenth. */
const small = 10;

/** Width, height and depth of the finished model, in whole millimetres unless one of them is small. */
export function finishedSize({ vertices }: Model, times = 'x'): string {
  const lengths = extentsOf(vertices).map((mm) => Number(mm.toFixed(mm < small ? 1 : 0)));
  return `${lengths.join(` ${times} `)} mm`;
}

/** What came out, in one line for people. */
export function summarize(
  name: string,
  { model, parts, pieces, sheets }: Pick<JobResult, 'model' | 'parts' | 'pieces' | 'sheets'>,
): string {
  const faces = count(model.faces.length / 3, 'face');
  const nets = `${count(parts, 'part')}, ${count(pieces.length, 'piece')}`;
  return `${name}: ${faces}, ${nets} on ${count(sheets.length, 'sheet')}, ${finishedSize(model)}`;
}
