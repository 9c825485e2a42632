import type { Piece } from '../model/job.js';
import type { Point } from './point.js';

/** A short text centred at (x, y); `size` is the font size; mm. */
export interface Label {
  text: string;
  x: number;
  y: number;
  size: number;
}

// Capitals of a sans-serif face: 0.72 em high and, but for a rare W, at most 0.8 em wide.
const capHeight = 0.72;
const capWidth = 0.8;

// The largest that fits is taken; below 2.5 mm (7 pt) a letter is hard to read beside fold lines.
const sizes = [6, 4.5, 3.5, 2.5];

// Around the text, so that it does not touch the lines of its face.
const clearance = 0.7;

/** Distance from the middle of a line of text down to its baseline, for capitals of this size. */
export function baselineDrop(size: number): number {
  return (size * capHeight) / 2;
}

/** Whether an upright box centred at `centre` lies inside a counter-clockwise triangle. */
function boxFits(triangle: Point[], centre: Point, halfWidth: number, halfHeight: number): boolean {
  return triangle.every((a, i) => {
    const b = triangle[(i + 1) % 3]!;
    const [ex, ey] = [b[0] - a[0], b[1] - a[1]];
    const cross = ex * (centre[1] - a[1]) - ey * (centre[0] - a[0]);
    return cross >= Math.abs(ex) * halfHeight + Math.abs(ey) * halfWidth;
  });
}

function inCentre(triangle: Point[]): Point {
  const opposite = triangle.map((_, i) => {
    const [a, b] = [triangle[(i + 1) % 3]!, triangle[(i + 2) % 3]!];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  });
  const around = opposite.reduce((sum, length) => sum + length, 0) || 1;
  const mean = (k: 0 | 1) => triangle.reduce((sum, p, i) => sum + p[k] * opposite[i]!, 0) / around;
  return [mean(0), mean(1)];
}

function triangles(piece: Piece): Point[][] {
  return Array.from({ length: piece.faces.length / 3 }, (_, face) =>
    [0, 1, 2].map((corner): Point => {
      const vertex = piece.faces[3 * face + corner]!;
      return [piece.vertices[2 * vertex]!, piece.vertices[2 * vertex + 1]!];
    }),
  );
}

function area([a, b, c]: Point[]): number {
  return ((b![0] - a![0]) * (c![1] - a![1]) - (b![1] - a![1]) * (c![0] - a![0])) / 2;
}

/** Centroid of the area of a piece. */
function centroid(faces: Point[][]): Point {
  let [x, y, total] = [0, 0, 0];
  for (const face of faces) {
    const weight = area(face);
    total += weight;
    x += (weight * (face[0]![0] + face[1]![0] + face[2]![0])) / 3;
    y += (weight * (face[0]![1] + face[1]![1] + face[2]![1])) / 3;
  }
  return total > 0 ? [x / total, y / total] : [0, 0];
}

/**
 * Place for a short text of capitals inside one face of a piece, in the piece's coordinates: as
 * large as readable sizes go, then as near to the centroid as there is a face with room for it;
 * null if no face has room. Linear in the faces.
 */
export function placeLabel(piece: Piece, text: string): Label | null {
  const faces = triangles(piece);
  const middle = centroid(faces);
  const centres = faces.map(inCentre);
  const distances = centres.map(([x, y]) => Math.hypot(x - middle[0], y - middle[1]));
  for (const size of sizes) {
    const halfWidth = (size * capWidth * text.length) / 2 + clearance;
    const halfHeight = baselineDrop(size) + clearance;
    let best = -1;
    for (let i = 0; i < faces.length; ++i) {
      if (best >= 0 && distances[i]! >= distances[best]!) continue;
      if (boxFits(faces[i]!, centres[i]!, halfWidth, halfHeight)) best = i;
    }
    if (best >= 0) return { text, x: centres[best]![0], y: centres[best]![1], size };
  }
  return null;
}
