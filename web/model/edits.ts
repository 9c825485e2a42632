import type { Edit, JobResult, JobStart } from './job.js';

/** Splits a part in so many. */
export function splitting(part: number, into = 2): Edit {
  return { parts: [part], into };
}

/** Merges parts that touch. */
export function merging(parts: number[]): Edit {
  return { parts, into: 1 };
}

/** What a job needs to change a result. */
export function startFrom({ labels, nets }: JobResult, edits: Edit[]): JobStart {
  return { labels, nets, edits };
}
