/** Where the names of pieces stand in a picture: on what is seen of them, or beside the picture with a line. */
import type { VisibleArea } from './hidden-surfaces.js';
import { boxOf } from './polygon.js';
import type { Fit } from './model-picture.js';
import type { ModelViews } from './model-views.js';
import type { Frame } from './picture-shape.js';
import type { Point } from './point.js';
import { capHeight, widthAtMost } from './text-line.js';

/** A name in a picture; `anchor` is the place on the piece that a line leads to. */
export interface PictureLetter {
  piece: number;
  text: string;
  /** Middle of the text. */
  at: Point;
  anchor: Point | null;
}

/** Side of the cells in which pieces are looked for; mm. */
const cell = 0.8;

/** The middle of the largest circle on what is seen of each piece. */
export function middlesOf(
  views: ModelViews,
  areas: readonly VisibleArea[],
  fit: Fit,
  frame: Frame,
): Map<number, { at: Point; radius: number }> {
  const columns = Math.ceil(frame.width / cell) + 2;
  const rows = Math.ceil(frame.height / cell) + 2;
  const cells = new Int32Array(columns * rows).fill(-1);
  const middle = (column: number, row: number): Point => [
    frame.left + (column - 0.5) * cell,
    frame.bottom + (row - 0.5) * cell,
  ];
  for (const { face, isBack, walk } of areas) {
    // The letter is that of the outer side.
    if (!isBack) fill(cells, columns, walk.map(fit), frame, views.pieceOf[face]!);
  }
  const depths = depthsOf(cells, columns);
  const best = new Map<number, { at: Point; radius: number }>();
  cells.forEach((piece, i) => {
    const radius = cell * depths[i]!;
    if (piece < 0 || radius <= (best.get(piece)?.radius ?? 0)) return;
    best.set(piece, { at: middle(i % columns, Math.floor(i / columns)), radius });
  });
  return best;
}

/** Gives the cells whose middles lie in a convex polygon to a piece. */
function fill(
  cells: Int32Array,
  columns: number,
  walk: readonly Point[],
  frame: Frame,
  piece: number,
): void {
  const [, bottom, , top] = boxOf(walk);
  const rowAt = (y: number): number => (y - frame.bottom) / cell + 0.5;
  for (let row = Math.max(0, Math.ceil(rowAt(bottom))); row <= rowAt(top); ++row) {
    const y = frame.bottom + (row - 0.5) * cell;
    let [from, to] = [Infinity, -Infinity];
    walk.forEach(([ax, ay], i) => {
      const [bx, by] = walk[(i + 1) % walk.length]!;
      if (ay > y === by > y) return;
      const x = ax + ((y - ay) / (by - ay)) * (bx - ax);
      [from, to] = [Math.min(from, x), Math.max(to, x)];
    });
    const last = (to - frame.left) / cell + 0.5;
    for (let c = Math.max(0, Math.ceil((from - frame.left) / cell + 0.5)); c <= last; ++c) {
      if (row * columns + c < cells.length) cells[row * columns + c] = piece;
    }
  }
}

/** How far every cell is from one of another piece, in cells, a step aside counting 1.4. */
function depthsOf(cells: Int32Array, columns: number): Float64Array {
  const depths = new Float64Array(cells.length).fill(Infinity);
  const sweep = (i: number, steps: readonly [offset: number, length: number][]): void => {
    for (const [offset, length] of steps) {
      const other = i + offset;
      const isSame = other >= 0 && other < cells.length && cells[other] === cells[i];
      depths[i] = Math.min(depths[i]!, isSame ? depths[other]! + length : 0.5);
    }
  };
  const before: [number, number][] = [
    [-1, 1],
    [-columns, 1],
    [-columns - 1, 1.4],
    [-columns + 1, 1.4],
  ];
  const after = before.map(([offset, length]): [number, number] => [-offset, length]);
  for (let i = 0; i < cells.length; ++i) sweep(i, before);
  for (let i = cells.length - 1; i >= 0; --i) sweep(i, after);
  return depths;
}

/** Names in columns at both sides of a picture, each at the height of its piece as far as there is room. */
function beside(letters: readonly PictureLetter[], frame: Frame, size: number): PictureLetter[] {
  const pitch = 1.35 * size;
  const places = Math.max(0, Math.floor(frame.height / pitch));
  const sorted = [...letters].sort((a, b) => b.anchor![1] - a.anchor![1]).slice(0, places);
  let top = frame.bottom + frame.height;
  const heights = sorted.map(({ anchor }) => {
    const y = Math.min(anchor![1], top - pitch / 2);
    top = y - pitch / 2;
    return y;
  });
  let bottom = frame.bottom;
  for (let i = heights.length - 1; i >= 0; --i) {
    heights[i] = Math.max(heights[i]!, bottom + pitch / 2);
    bottom = heights[i]! + pitch / 2;
  }
  return sorted.map((letter, i) => ({ ...letter, at: [letter.at[0], heights[i]!] }));
}

/**
 * The names of all pieces of which something is seen. A name that does not go onto its piece stands in a
 * column of this width at the left or the right of the frame.
 */
export function placeLetters(
  found: ReadonlyMap<number, { at: Point; radius: number }>,
  names: readonly string[],
  { frame, side, size }: { frame: Frame; side: number; size: number },
): PictureLetter[] {
  const inside: PictureLetter[] = [];
  const [left, right]: PictureLetter[][] = [[], []];
  for (const [piece, { at, radius }] of [...found].sort(([a], [b]) => a - b)) {
    const text = names[piece]!;
    const [half, rise] = [widthAtMost(text, size) / 2, (capHeight * size) / 2];
    if (Math.sqrt(half * half + rise * rise) <= radius) {
      inside.push({ piece, text, at, anchor: null });
      continue;
    }
    const isLeft = at[0] < frame.left + frame.width / 2;
    const x = isLeft ? frame.left - side + half : frame.left + frame.width + side - half;
    (isLeft ? left! : right!).push({ piece, text, at: [x, at[1]], anchor: at });
  }
  return [...inside, ...beside(left!, frame, size), ...beside(right!, frame, size)];
}
