import { extentsOf } from '../model/bounds.js';
import type { JobResult, Model } from '../model/job.js';
import type { Words } from './words.js';

/** Below so many mm a length is told to a tenth. */
const small = 10;

/** Width, height and depth in mm, whole ones unless one of them is small. */
export function sizeWords({ speech }: Words, lengths: readonly number[], times = 'x'): string {
  const told = lengths.map((mm) => speech.figure(Number(mm.toFixed(mm < small ? 1 : 0))));
  return `${told.join(` ${times} `)} mm`;
}

/** The same of the finished model. */
export function finishedSize(words: Words, { vertices }: Model, times = 'x'): string {
  return sizeWords(words, extentsOf(vertices), times);
}

/** What came out, in one line for people. */
export function summarize(
  words: Words,
  name: string,
  { model, parts, pieces, sheets }: Pick<JobResult, 'model' | 'parts' | 'pieces' | 'sheets'>,
): string {
  return words.command.summary({
    name,
    faces: model.faces.length / 3,
    parts,
    pieces: pieces.length,
    sheets: sheets.length,
    size: finishedSize(words, model),
  });
}
