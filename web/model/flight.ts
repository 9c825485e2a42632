import type { Ball } from './bounds.js';
import { posed, turnAround, turnBetween, turned, type Pose, type Turn } from './pose.js';
import { cross, direction, dot, length, minus, plus, times, type Vector } from './vector.js';

/** How a piece goes from the table into the model. */
export interface Flight {
  start: Pose;
  end: Pose;
  /** Around the folded piece, on its sheet. */
  ball: Ball;
  /** Around the model. */
  model: Ball;
  /** The direction away from the table, of unit length, and how far it has to rise from there to be
   * clear of its neighbours. */
  up: Vector;
  lift: number;
  /** The direction from which it comes straight into the model; of unit length. */
  from: Vector;
}

/** A pose at a share of the flight, in [0, 1]. */
export interface FlightKey {
  share: number;
  pose: Pose;
}

/** Shares of a flight for the rise and for the straight way in; between them it circles. */
const rise = 0.2;
export const descent = 0.3;

/** Straight stretches in place of the arc around the model. */
const stretches = 8;

/** The pose with this turn in which `point` of the sheet lies at `place`. */
function poseAt(turn: Turn, point: Vector, place: Vector): Pose {
  return { turn, move: minus(place, turned(turn, point)) };
}

/** The direction between two others of unit length, on the shorter arc. */
function directionBetween(a: Vector, b: Vector, share: number): Vector {
  // Any axis across will do where the two are opposite.
  const across = Math.abs(a[0]) < 0.9 ? cross(a, [1, 0, 0]) : cross(a, [0, 1, 0]);
  const axis = cross(a, b);
  const angle = Math.atan2(length(axis), dot(a, b));
  return turned(turnAround(direction(length(axis) > 1e-9 ? axis : across), share * angle), a);
}

/**
 * The keys of a flight: up from the table, then around the model so far out that nothing of the
 * piece comes near it, and straight in from there. The piece is turned while it circles.
 */
export function flightKeys({ start, end, ball, model, up, lift, from }: Flight): FlightKey[] {
  const outside = model.radius + ball.radius;
  const goal = minus(posed(end, ball.centre), model.centre);
  const along = dot(goal, from);
  const way = Math.sqrt(along ** 2 - dot(goal, goal) + outside ** 2) - along;
  const gate = plus(goal, times(from, way));
  const lifted = minus(plus(posed(start, ball.centre), times(up, lift)), model.centre);
  const keys: FlightKey[] = [{ share: 0, pose: start }];
  for (let stretch = 0; stretch <= stretches; ++stretch) {
    const share = stretch / stretches;
    const distance = (1 - share) * length(lifted) + share * length(gate);
    const arc = directionBetween(direction(lifted), direction(gate), share);
    const turn = turnBetween(start.turn, end.turn, share);
    const place = times(arc, distance);
    // On its way outwards over the table an arc may sink, but its neighbours still lie there.
    const sunk = Math.min(0, dot(minus(place, lifted), up));
    keys.push({
      share: rise + share * (1 - rise - descent),
      pose: poseAt(turn, ball.centre, plus(model.centre, minus(place, times(up, sunk)))),
    });
  }
  return [...keys, { share: 1, pose: end }];
}
