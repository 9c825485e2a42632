/** Pieces that are cut and folded alike: crates of a stack, legs of a table. */
import type { JobResult, Notice, Piece } from './job.js';

/** Below what scissors can tell; mm. */
const sameLength = 0.05;

/** Below what a fold shows; degrees. */
const sameAngle = 0.5;

/** An outline as it feels to a pair of scissors: how far along each side, and how far to turn then. */
interface Walk {
  lengths: number[];
  /** From each side to the next one; degrees. */
  turns: number[];
}

interface Shape {
  name: string;
  faces: number;
  walks: Walk[];
  /** Ascending; degrees. */
  folds: number[];
}

function walkAlong(piece: Piece, outline: Int32Array): Walk {
  const at = (i: number): [number, number] => {
    const vertex = outline[i % outline.length]!;
    return [piece.vertices[2 * vertex]!, piece.vertices[2 * vertex + 1]!];
  };
  const sides = Array.from(outline, (_, i) => {
    const [x, y] = at(i);
    const [nextX, nextY] = at(i + 1);
    return [nextX - x, nextY - y] as const;
  });
  return {
    lengths: sides.map(([x, y]) => Math.hypot(x, y)),
    turns: sides.map(([x, y], i) => {
      const [nextX, nextY] = sides[(i + 1) % sides.length]!;
      const turn = Math.atan2(x * nextY - y * nextX, x * nextX + y * nextY);
      return (180 / Math.PI) * turn;
    }),
  };
}

function shapeOf(piece: Piece): Shape {
  return {
    name: piece.name,
    faces: piece.sources.length,
    walks: piece.outlines.map((outline) => walkAlong(piece, outline)),
    folds: [...piece.foldAngles].filter((angle) => !Number.isNaN(angle)).sort((a, b) => a - b),
  };
}

function areNear(a: readonly number[], b: readonly number[], by: number, shift = 0): boolean {
  return (
    a.length === b.length &&
    a.every((value, i) => Math.abs(value - b[(i + shift) % b.length]!) <= by)
  );
}

/** A slit turns by half a turn, whichever way round. */
function areSameTurns(a: readonly number[], b: readonly number[], shift: number): boolean {
  return a.every((turn, i) => {
    const apart = Math.abs(turn - b[(i + shift) % b.length]!);
    return Math.min(apart, 360 - apart) <= sameAngle;
  });
}

/** The same outline, wherever it begins. */
function areSameWalks(a: Walk, b: Walk): boolean {
  return a.lengths.some(
    (_, shift) =>
      areNear(a.lengths, b.lengths, sameLength, shift) && areSameTurns(a.turns, b.turns, shift),
  );
}

function areEqual(a: Shape, b: Shape): boolean {
  return (
    a.faces === b.faces &&
    a.walks.length === b.walks.length &&
    areNear(a.folds, b.folds, sameAngle) &&
    a.walks.every((walk) => b.walks.some((other) => areSameWalks(walk, other)))
  );
}

/**
 * The names of pieces that are equal, two or more in each group, in their order in the result. Mirror images
 * are not equal. Flaps, numbers and colours do not count.
 */
export function equalPieces({ pieces }: JobResult): string[][] {
  const groups: { shape: Shape; names: string[] }[] = [];
  for (const piece of pieces) {
    const shape = shapeOf(piece);
    const group = groups.find((other) => areEqual(shape, other.shape));
    if (group) group.names.push(piece.name);
    else groups.push({ shape, names: [piece.name] });
  }
  return groups.map(({ names }) => names).filter((names) => names.length > 1);
}

/** A notice for each group of equal pieces. */
export function equalPiecesNotices(result: JobResult): Notice[] {
  return equalPieces(result).map((pieces) => ({ code: 'equal-pieces', params: { pieces } }));
}
