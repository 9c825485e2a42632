import type { JobResult } from '../model/job.js';

function count(number: number, noun: string): string {
  return `${number} ${noun}${number === 1 ? '' : 's'}`;
}

/** What came out, in one line for people. */
export function summarize(
  model: string,
  { model: mesh, parts, pieces, sheets }: JobResult,
): string {
  const faces = count(mesh.faces.length / 3, 'face');
  const nets = `${count(parts, 'part')}, ${count(pieces.length, 'piece')}`;
  return `${model}: ${faces}, ${nets} on ${count(sheets.length, 'sheet')}`;
}
