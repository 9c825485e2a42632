import { foldEnd } from './choreography.js';

/** How many seconds the folding takes when it is played, and the coming together after it. */
export interface Tempo {
  fold: number;
  join: number;
}

/** So slow that one can follow every piece, and so quick that many of them do not tire. */
export function tempoFor(pieces: number): Tempo {
  return { fold: 6, join: Math.min(2 + 0.8 * pieces, 12) };
}

/** The second at which a time from 0 to 1 has come. */
export function secondOf({ fold, join }: Tempo, time: number): number {
  return time < foldEnd
    ? (time / foldEnd) * fold
    : fold + ((time - foldEnd) / (1 - foldEnd)) * join;
}

/** The time from 0 to 1 at a second; 1 after the end. */
export function timeAt({ fold, join }: Tempo, second: number): number {
  const time =
    second < fold ? (second / fold) * foldEnd : foldEnd + ((second - fold) / join) * (1 - foldEnd);
  return Math.min(time, 1);
}
