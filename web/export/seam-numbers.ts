/** Which number is printed at which seam, as a person finds it: by where the numbers stand on the pieces. */
import { cutPairs, type CutSide } from '../model/borders.js';
import type { Piece, PieceLabel } from '../model/job.js';
import type { Point } from './point.js';

/** A number on a piece. */
interface Spot {
  digits: string;
  /** Its middle, and the ends of the line that leads to its edge. */
  points: Point[];
  /** How far it is from the nearest cut edge of its piece; mm. */
  nearest: number;
}

/** A number that may be that of a seam, with all places beside it where that number stands. */
interface Match {
  pair: number;
  digits: string;
  /** How much farther both numbers are from these edges than from the nearest ones; mm. */
  detour: number;
  beside: Spot[];
}

// The farthest that a number without a line to its edge stands from it; mm. On a flap it is its height.
const reach = 8;
// Nearly all numbers stand nearest to their own edges; of 1700 on organic models eight do not, by 0.3 mm and more.
const mostDetour = 2;
// So close to the edge of a seam that has the same number, it is that seam's: on the face, or on the flap.
const own = 4;

/** The number in a text such as 12, C:12 or C12; null for a text that is none. */
export function numberIn(text: string): string | null {
  return /\d+$/.exec(text)?.[0] ?? null;
}

function spotOf(piece: Piece, { leader, text, x, y }: PieceLabel): Spot[] {
  const digits = numberIn(text);
  if (digits === null) return [];
  const ends: Point[] = leader
    ? [
        [leader[0]!, leader[1]!],
        [leader[2]!, leader[3]!],
      ]
    : [[x, y]];
  const edges = [...piece.assignments].flatMap((kind, edge) => (kind === 'B' ? [edge] : []));
  const spot = { digits, points: ends, nearest: 0 };
  const nearest = Math.min(...edges.map((edge) => distanceOf(piece, edge, spot)));
  return [{ ...spot, nearest }];
}

/** Distance of a point from an edge of a piece. */
function distanceFrom({ edges, vertices }: Piece, edge: number, [x, y]: Point): number {
  const [a, b] = [2 * edges[2 * edge]!, 2 * edges[2 * edge + 1]!];
  const [dx, dy] = [vertices[b]! - vertices[a]!, vertices[b + 1]! - vertices[a + 1]!];
  const [px, py] = [x - vertices[a]!, y - vertices[a + 1]!];
  const share = Math.max(0, Math.min(1, (px * dx + py * dy) / (dx * dx + dy * dy)));
  return Math.sqrt((px - share * dx) ** 2 + (py - share * dy) ** 2);
}

function distanceOf(piece: Piece, edge: number, { points }: Spot): number {
  return Math.min(...points.map((point) => distanceFrom(piece, edge, point)));
}

/** The numbers near an edge, by spot, and how far away they are. */
function nearEdge(
  piece: Piece,
  spots: readonly Spot[],
  edge: number,
): Map<string, [Spot, number][]> {
  const near = new Map<string, [Spot, number][]>();
  for (const spot of spots) {
    const distance = distanceOf(piece, edge, spot);
    if (distance > reach) continue;
    near.set(spot.digits, [...(near.get(spot.digits) ?? []), [spot, distance]]);
  }
  return near;
}

/** The numbers that stand at both sides of a pair, each at a place of its own. */
function matchesOf(
  pieces: readonly Piece[],
  spots: readonly (readonly Spot[])[],
  [a, b]: readonly [CutSide, CutSide],
  pair: number,
): Match[] {
  const [here, there] = [a, b].map(({ edge, piece }) =>
    nearEdge(pieces[piece]!, spots[piece]!, edge),
  );
  const matches: Match[] = [];
  for (const [digits, ones] of here!) {
    const others = there!.get(digits) ?? [];
    const close = [...ones, ...others].filter(([, distance]) => distance < own);
    for (const [one, near] of ones) {
      for (const [other, far] of others) {
        if (one === other) continue;
        const detour = near - one.nearest + far - other.nearest;
        if (detour > mostDetour) continue;
        const beside = [one, other, ...close.map(([spot]) => spot)];
        matches.push({ pair, digits, detour, beside });
      }
    }
  }
  return matches;
}

/**
 * The numbers of seams by their edge of the model. Seams whose number does not stand at both sides have
 * none. Numbers of seams between the same two pieces differ.
 */
export function seamNumbers(pieces: readonly Piece[]): Map<number, string> {
  const spots = pieces.map((piece) =>
    piece.labels.filter(({ text }) => text !== piece.name).flatMap((label) => spotOf(piece, label)),
  );
  const pairs = cutPairs(pieces);
  const matches = pairs.flatMap((pair, index) => matchesOf(pieces, spots, pair, index));
  matches.sort((a, b) => a.detour - b.detour || a.pair - b.pair);
  const numbers = new Map<number, string>();
  const taken = new Set<Spot>();
  for (const { beside, digits, pair } of matches) {
    const [{ edge, piece }] = pairs[pair]!;
    const modelEdge = pieces[piece]!.modelEdges[edge]!;
    if (numbers.has(modelEdge) || taken.has(beside[0]!) || taken.has(beside[1]!)) continue;
    for (const spot of beside) taken.add(spot);
    numbers.set(modelEdge, digits);
  }
  return numbers;
}

/** Numbers in the order in which they are used: 12–17, 20, 9–7. */
export function numberRuns(numbers: readonly string[]): string[] {
  const runs: { from: number; to: number; step: number }[] = [];
  for (const number of numbers.map(Number)) {
    const last = runs.at(-1);
    const step = last ? number - last.to : 0;
    if (last && Math.abs(step) === 1 && (last.step === 0 || last.step === step)) {
      Object.assign(last, { to: number, step });
    } else {
      runs.push({ from: number, to: number, step: 0 });
    }
  }
  return runs.flatMap(({ from, to }) => {
    if (from === to) return [`${from}`];
    return Math.abs(to - from) === 1 ? [`${from}`, `${to}`] : [`${from}–${to}`];
  });
}
