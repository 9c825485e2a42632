/** Which number is printed at which seam, as a person finds it: by where the numbers stand on the pieces. */
import { cutPairs, type CutSide } from '../model/borders.js';
import type { Piece, PieceLabel } from '../model/job.js';
import type { Point } from './point.js';

/** A number on a piece. */
interface Spot {
  digits: string;
  /** Its middle, and the ends of the line that leads to its edge. */
  points: Point[];
}

/** A number that may be that of a seam. */
interface Match {
  pair: number;
  digits: string;
  /** Of both numbers from their edges; mm. */
  distance: number;
}

// The farthest that a number without a line to its edge stands from it; mm. On a flap it is its height.
const reach = 8;

/** The number in a text such as 12, C:12 or C12; null for a text that is none. */
export function numberIn(text: string): string | null {
  return /\d+$/.exec(text)?.[0] ?? null;
}

function spotOf({ leader, text, x, y }: PieceLabel): Spot[] {
  const digits = numberIn(text);
  if (digits === null) return [];
  const ends: Point[] = leader
    ? [
        [leader[0]!, leader[1]!],
        [leader[2]!, leader[3]!],
      ]
    : [[x, y]];
  return [{ digits, points: ends }];
}

/** Distance of a point from an edge of a piece. */
function distanceFrom({ edges, vertices }: Piece, edge: number, [x, y]: Point): number {
  const [a, b] = [2 * edges[2 * edge]!, 2 * edges[2 * edge + 1]!];
  const [dx, dy] = [vertices[b]! - vertices[a]!, vertices[b + 1]! - vertices[a + 1]!];
  const [px, py] = [x - vertices[a]!, y - vertices[a + 1]!];
  const share = Math.max(0, Math.min(1, (px * dx + py * dy) / (dx * dx + dy * dy)));
  return Math.sqrt((px - share * dx) ** 2 + (py - share * dy) ** 2);
}

/** The numbers near an edge, by spot, and how far away they are. */
function nearEdge(
  piece: Piece,
  spots: readonly Spot[],
  edge: number,
): Map<string, [Spot, number][]> {
  const near = new Map<string, [Spot, number][]>();
  for (const spot of spots) {
    const distance = Math.min(...spot.points.map((point) => distanceFrom(piece, edge, point)));
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
    const sums = ones.flatMap(([one, near]) =>
      others.flatMap(([other, far]) => (one === other ? [] : [near + far])),
    );
    if (sums.length > 0) matches.push({ pair, digits, distance: Math.min(...sums) });
  }
  return matches;
}

/**
 * The numbers of seams by their edge of the model. Seams whose number does not stand at both sides have
 * none. Numbers of seams between the same two pieces differ.
 */
export function seamNumbers(pieces: readonly Piece[]): Map<number, string> {
  const spots = pieces.map(({ labels, name }) =>
    labels.filter(({ text }) => text !== name).flatMap(spotOf),
  );
  const pairs = cutPairs(pieces);
  const matches = pairs.flatMap((pair, index) => matchesOf(pieces, spots, pair, index));
  matches.sort((a, b) => a.distance - b.distance || a.pair - b.pair);
  const numbers = new Map<number, string>();
  const taken = new Set<string>();
  for (const { pair, digits } of matches) {
    const [a, b] = pairs[pair]!;
    const edge = pieces[a.piece]!.modelEdges[a.edge]!;
    const key = [a.piece, b.piece].sort((p, q) => p - q).join(' ') + ' ' + digits;
    if (numbers.has(edge) || taken.has(key)) continue;
    taken.add(key);
    numbers.set(edge, digits);
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
