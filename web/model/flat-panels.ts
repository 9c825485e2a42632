/** Flat panels of pieces, which are never cut, so that each must lie on a sheet as it is. */
import { Groups } from './groups.js';
import type { Piece } from './job.js';

/** x and y of the corners of the faces that a panel has. */
type Panel = readonly (readonly [number, number])[];

/** Pairs of faces that go on flat into each other. */
function flatPairs({ assignments, edges, faces, vertices }: Piece): [number, number][] {
  const count = vertices.length / 2;
  const key = (a: number, b: number): number => Math.min(a, b) * count + Math.max(a, b);
  const flat = new Set<number>();
  for (let edge = 0; edge < assignments.length; ++edge) {
    if (assignments[edge] === 'F') flat.add(key(edges[2 * edge]!, edges[2 * edge + 1]!));
  }
  const first = new Map<number, number>();
  const pairs: [number, number][] = [];
  faces.forEach((from, at) => {
    const face = Math.floor(at / 3);
    const name = key(from, faces[3 * face + ((at + 1) % 3)]!);
    if (!flat.has(name)) return;
    const other = first.get(name);
    if (other === undefined) first.set(name, face);
    else pairs.push([other, face]);
  });
  return pairs;
}

function panelsOf(piece: Piece): Panel[] {
  const { faces, vertices } = piece;
  const groups = new Groups(faces.length / 3);
  for (const [a, b] of flatPairs(piece)) groups.unite(a, b);
  const panels = new Map<number, [number, number][]>();
  faces.forEach((vertex, at) => {
    const group = groups.of(Math.floor(at / 3));
    const corners = panels.get(group) ?? [];
    corners.push([vertices[2 * vertex]!, vertices[2 * vertex + 1]!]);
    panels.set(group, corners);
  });
  return [...panels.values()];
}

/** The extent of a panel in a direction. */
function extent(panel: Panel, angle: number): number {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  let [low, high] = [Infinity, -Infinity];
  for (const [x, y] of panel) {
    const along = cos * x + sin * y;
    low = Math.min(low, along);
    high = Math.max(high, along);
  }
  return high - low;
}

const right = Math.PI / 2;
/** Between turns that are tried: 3 degrees, as in the engine. */
const step = Math.PI / 60;

/** What is lost to rounding when a panel that just fits is turned, mm. */
const slack = 1e-6;

function fitsTurned(panel: Panel, width: number, height: number): boolean {
  for (let angle = 0; angle < 2 * right; angle += step) {
    const isWithin =
      extent(panel, angle) <= width + slack && extent(panel, angle + right) <= height + slack;
    if (isWithin) return true;
  }
  return false;
}

/** Whether every flat panel fits into a rectangle of so many mm in some turn. */
export function doPanelsFit(pieces: readonly Piece[], width: number, height: number): boolean {
  return pieces.flatMap(panelsOf).every((panel) => {
    // Most are that small.
    const isSmall = Math.hypot(extent(panel, 0), extent(panel, right)) <= Math.min(width, height);
    return isSmall || fitsTurned(panel, width, height);
  });
}
