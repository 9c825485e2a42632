import { meets, type Box } from './box.js';
import type { Point, Segment } from './point.js';
import { capHeight, directionOf, widthAtMost, type TextLine } from './text-line.js';

/** A fold that is drawn, and how far it folds. */
export interface AngledFold {
  line: Segment;
  /** Degrees; the sign does not matter. */
  angle: number;
}

/** Sizes of fonts, the best first; mm. Below 4 points nobody reads. */
const sizes = [1.8, 1.4];
/** Where along its fold a text may have its middle. */
const places = [0.5, 0.35, 0.65];
/** From all lines. */
const clearance = 0.3;
/** Side of the cells in which lines are kept; mm. */
const cell = 5;

function cornersOf({ middle, along, halfWidth, halfHeight }: Box): Point[] {
  return [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ].map(([i, j]): Point => {
    const [x, y] = [i! * halfWidth, j! * halfHeight];
    return [middle[0] + x * along[0] - y * along[1], middle[1] + x * along[1] + y * along[0]];
  });
}

/** Lines by where they are. */
class Lines {
  private readonly cells = new Map<string, Segment[]>();

  add(line: Segment): void {
    for (const key of this.keys(line)) {
      const known = this.cells.get(key);
      if (known) known.push(line);
      else this.cells.set(key, [line]);
    }
  }

  meet(box: Box): boolean {
    return [...this.keys(cornersOf(box))].some((key) =>
      (this.cells.get(key) ?? []).some((line) => meets(box, line)),
    );
  }

  private *keys(points: readonly Point[]): Generator<string> {
    const range = (k: 0 | 1): [number, number] => [
      Math.floor(Math.min(...points.map((point) => point[k])) / cell),
      Math.floor(Math.max(...points.map((point) => point[k])) / cell),
    ];
    const [[left, right], [bottom, top]] = [range(0), range(1)];
    for (let i = left; i <= right; ++i) for (let j = bottom; j <= top; ++j) yield `${i} ${j}`;
  }
}

function boxOf({ text, at, anchor, angle, size }: TextLine): Box {
  const along = directionOf(angle);
  const halfWidth = widthAtMost(text, size) / 2;
  const [shift, rise] = [anchor === 'start' ? halfWidth : 0, (capHeight * size) / 2];
  return {
    middle: [
      at[0] + shift * along[0] - rise * along[1],
      at[1] + shift * along[1] + rise * along[0],
    ],
    along,
    halfWidth: halfWidth + clearance / 2,
    halfHeight: rise + clearance / 2,
  };
}

/** Places for the text of a fold, the best first: beside its middle, on either side, then smaller. */
function* candidates({ line: [from, to], angle }: AngledFold): Generator<TextLine> {
  const text = `${Math.round(Math.abs(angle))}°`;
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const turn = (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;
  const upright = turn > 90 ? turn - 180 : turn <= -90 ? turn + 180 : turn;
  // A millionth of a degree: the last digits differ between browsers, and files do not.
  const along = Math.round(1e6 * upright) / 1e6;
  const [cosine, sine] = directionOf(along);
  for (const size of sizes) {
    const half = widthAtMost(text, size) / 2 + clearance;
    for (const share of places) {
      if (half > Math.min(share, 1 - share) * length) continue;
      const x = from[0] + share * (to[0] - from[0]);
      const y = from[1] + share * (to[1] - from[1]);
      for (const rise of [2 * clearance, -2 * clearance - capHeight * size]) {
        const at: Point = [x - rise * sine, y + rise * cosine];
        yield { text, at, anchor: 'middle', angle: along, size };
      }
    }
  }
}

/**
 * Texts that tell how far folds fold, in degrees from flat, where there is room beside them: on the
 * piece, touching no line and no other text. A fold without room gets none.
 *
 * @param lines all lines of the piece, the folds among them
 * @param texts what is written on it already
 */
export function tellAngles(
  folds: readonly AngledFold[],
  lines: readonly Segment[],
  texts: readonly TextLine[],
): TextLine[] {
  const taken = new Lines();
  for (const line of lines) taken.add(line);
  const close = (box: Box): void => {
    const corners = cornersOf(box);
    corners.forEach((corner, i) => taken.add([corner, corners[(i + 1) % 4]!]));
    // One text might lie within another.
    taken.add([corners[0]!, corners[2]!]);
  };
  for (const text of texts) close(boxOf(text));
  const told: TextLine[] = [];
  for (const fold of folds) {
    for (const text of candidates(fold)) {
      const box = boxOf(text);
      if (taken.meet(box)) continue;
      told.push(text);
      close(box);
      break;
    }
  }
  return told;
}
