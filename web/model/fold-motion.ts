import type { Motion, Piece } from './job.js';

/** The keys around `time`, and how far it is from the first to the second, in [0, 1]. */
function keysAround({ times }: Motion, time: number): { key: number; share: number } {
  let key = 0;
  while (key + 2 < times.length && times[key + 1]! <= time) ++key;
  return { key, share: (time - times[key]!) / (times[key + 1]! - times[key]!) };
}

/**
 * The angles of all edges of a piece in degrees, as its `foldAngles`, at a time from 0 (flat) to 1
 * (folded); cut edges have 0. Without a motion all folds turn evenly, and faces may run into each
 * other. Edges that are flat on paper take on their bend of less than 0.001 degrees evenly, too, so
 * that the folded piece is the model to the last digits.
 */
export function anglesAt({ foldAngles, assignments, motion }: Piece, time: number): Float64Array {
  const around = motion && keysAround(motion, time);
  return foldAngles.map((full, edge) => {
    if (assignments[edge] === 'B') return 0;
    if (!around || assignments[edge] === 'F') return time * full;
    const { key, share } = around;
    const from = motion.angles[key * foldAngles.length + edge]!;
    const to = motion.angles[(key + 1) * foldAngles.length + edge]!;
    return (1 - share) * from + share * to;
  });
}
