/** What someone who watches the folding has in view, from the nets on the table to the model. */
import { boxOf, type Box3 } from '../model/bounds.js';
import { atOrigin, turnBack, turned, type Pose } from '../model/pose.js';
import { dot, plus, times, type Vector } from '../model/vector.js';

/** Directions to the right, up and towards someone who looks at the middle: at right angles, of unit length. */
export type ViewAxes = readonly [Vector, Vector, Vector];

/** @param around the upright axis, and `height` above the horizon: angles in radians */
export function viewAxes(around: number, height: number): ViewAxes {
  const [sine, cosine] = [Math.sin(around), Math.cos(around)];
  const [up, level] = [Math.sin(height), Math.cos(height)];
  return [
    [cosine, 0, -sine],
    [-sine * up, level, -cosine * up],
    [sine * level, up, cosine * level],
  ];
}

/** The box around points in a pose, of an array of 3 numbers per point, along the axes of a view. */
export function boxSeen(
  points: Float64Array,
  axes: ViewAxes,
  { turn, move }: Pose = atOrigin,
): Box3 {
  const back = turnBack(turn);
  const ranges = axes.map((axis) => {
    // To turn the axis once is quicker than to turn all points.
    const [x, y, z] = turned(back, axis);
    const offset = dot(axis, move);
    let [low, high] = [Infinity, -Infinity];
    for (let i = 0; i < points.length; i += 3) {
      const along = x * points[i]! + y * points[i + 1]! + z * points[i + 2]! + offset;
      if (along < low) low = along;
      if (along > high) high = along;
    }
    return [low, high] as const;
  });
  const [a, b, c] = ranges;
  return { low: [a![0], b![0], c![0]], high: [a![1], b![1], c![1]] };
}

/** The middle of a box along the axes of a view, in space. */
export function middleSeen({ low, high }: Box3, axes: ViewAxes): Vector {
  return axes.reduce<Vector>(
    (sum, axis, k) => plus(sum, times(axis, (low[k]! + high[k]!) / 2)),
    [0, 0, 0],
  );
}

/**
 * Looks before and after each one: what they see is in view as well, and boxes are evened out with those of as many, so
 * that nobody notices when another piece counts.
 */
const nearby = 2;

/** The box around boxes. */
export function around(...boxes: Box3[]): Box3 {
  return boxOf(...boxes.flatMap(({ low, high }) => [low, high]));
}

function mean(boxes: readonly Box3[]): Box3 {
  const sum = boxes.reduce((a, b) => ({ low: plus(a.low, b.low), high: plus(a.high, b.high) }));
  return { low: times(sum.low, 1 / boxes.length), high: times(sum.high, 1 / boxes.length) };
}

function between(a: Box3, b: Box3, share: number): Box3 {
  const mix = (from: Vector, to: Vector): Vector => plus(times(from, 1 - share), times(to, share));
  return { low: mix(a.low, b.low), high: mix(a.high, b.high) };
}

/** A box in view at any time, around those at the times nearby: it changes evenly, without haste. */
export class CameraPath {
  private readonly boxes: Box3[];

  /** @param times ascending; `boxes` at these times */
  constructor(
    private readonly times: readonly number[],
    boxes: readonly Box3[],
  ) {
    const wide = boxes.map((_, i) =>
      around(...boxes.slice(Math.max(0, i - nearby), i + nearby + 1)),
    );
    this.boxes = wide.map((_, i) => {
      const reach = Math.min(nearby, i, boxes.length - 1 - i);
      return mean(wide.slice(i - reach, i + reach + 1));
    });
  }

  at(time: number): Box3 {
    const next = this.times.findIndex((other) => other > time);
    if (next <= 0) return this.boxes.at(next)!;
    const [from, to] = [this.times[next - 1]!, this.times[next]!];
    return between(this.boxes[next - 1]!, this.boxes[next]!, (time - from) / (to - from));
  }
}
