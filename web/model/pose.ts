import { cross, direction, dot, length, minus, plus, times, type Vector } from './vector.js';

/** A rotation: a quaternion of unit length, the real part last. */
export type Turn = readonly [x: number, y: number, z: number, w: number];

/** A rigid motion: first the turn around the origin, then the move. */
export interface Pose {
  turn: Turn;
  move: Vector;
}

export const noTurn: Turn = [0, 0, 0, 1];
export const atOrigin: Pose = { turn: noTurn, move: [0, 0, 0] };

/** The turn by an angle in radians around an axis of unit length, counter-clockwise seen from its tip. */
export function turnAround(axis: Vector, angle: number): Turn {
  const sine = Math.sin(angle / 2);
  return [axis[0] * sine, axis[1] * sine, axis[2] * sine, Math.cos(angle / 2)];
}

/** One turn after another: first `b`, then `a`. Its length is mended, or errors would add up. */
export function turnAfter(a: Turn, b: Turn): Turn {
  const [x, y, z, w] = [
    a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
    a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
    a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
  ];
  const size = Math.sqrt(x * x + y * y + z * z + w * w);
  return [x / size, y / size, z / size, w / size];
}

export function turnBack([x, y, z, w]: Turn): Turn {
  return [-x, -y, -z, w];
}

/** A vector after a turn. */
export function turned([x, y, z, w]: Turn, v: Vector): Vector {
  const u: Vector = [x, y, z];
  const twice = times(cross(u, v), 2);
  return plus(plus(v, times(twice, w)), cross(u, twice));
}

/** A point after a pose. */
export function posed({ turn, move }: Pose, point: Vector): Vector {
  return plus(turned(turn, point), move);
}

/** One pose after another: first `b`, then `a`. */
export function poseAfter(a: Pose, b: Pose): Pose {
  return { turn: turnAfter(a.turn, b.turn), move: posed(a, b.move) };
}

/** The pose that brings a point of one pose's making back. */
export function poseBack({ turn, move }: Pose): Pose {
  const back = turnBack(turn);
  return { turn: back, move: times(turned(back, move), -1) };
}

/** The turn about a point instead of the origin. */
export function turnAbout(point: Vector, turn: Turn): Pose {
  return { turn, move: minus(point, turned(turn, point)) };
}

/** The way from one turn to another at constant speed, the shorter one; `share` in [0, 1]. */
export function turnBetween(a: Turn, b: Turn, share: number): Turn {
  const cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = cosine < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  // So close to each other that the sines have no digits left: straight is as good.
  const [p, q] =
    angle < 1e-6
      ? [1 - share, share * sign]
      : [Math.sin((1 - share) * angle), sign * Math.sin(share * angle)];
  // Mends the length, too.
  return turnAfter(
    [a[0] * p + b[0] * q, a[1] * p + b[1] * q, a[2] * p + b[2] * q, a[3] * p + b[3] * q],
    noTurn,
  );
}

/** The turn that takes the axes x, y, z to these three, which are of unit length and right-handed. */
function turnOfAxes(x: Vector, y: Vector, z: Vector): Turn {
  const trace = x[0] + y[1] + z[2];
  // The largest of the four parts is divided by, so that no digits are lost.
  const parts = [x[0], y[1], z[2], trace];
  const largest = parts.indexOf(Math.max(...parts));
  const four: Turn[] = [
    [1 + x[0] - y[1] - z[2], x[1] + y[0], z[0] + x[2], y[2] - z[1]],
    [x[1] + y[0], 1 + y[1] - x[0] - z[2], y[2] + z[1], z[0] - x[2]],
    [z[0] + x[2], y[2] + z[1], 1 + z[2] - x[0] - y[1], x[1] - y[0]],
    [y[2] - z[1], z[0] - x[2], x[1] - y[0], 1 + trace],
  ];
  return turnAfter(four[largest]!, noTurn);
}

/** The turn that takes the axes to a triangle's: x along its longest side, z along its normal. */
function turnOfTriangle(corners: readonly Vector[]): Turn {
  const sides = corners.map((corner, i) => minus(corners[(i + 1) % 3]!, corner));
  // Short sides of a thin triangle have no direction that could be relied on.
  const sizes = sides.map(length);
  const at = sizes.indexOf(Math.max(...sizes));
  const x = direction(sides[at]!);
  const aside = sides[(at + 1) % 3]!;
  const y = direction(minus(aside, times(x, dot(aside, x))));
  return turnOfAxes(x, y, cross(x, y));
}

/** The pose that takes a triangle to a congruent one, corner by corner; neither may be a line. */
export function poseOnto(from: readonly Vector[], to: readonly Vector[]): Pose {
  const turn = turnAfter(turnOfTriangle(to), turnBack(turnOfTriangle(from)));
  return { turn, move: minus(to[0]!, turned(turn, from[0]!)) };
}
