/**
 * How pieces that lie side by side become the model, over a time from 0 to 1: until `foldEnd` each
 * folds up where it lies, then one after the other flies to its place.
 */
import type { Body } from './body.js';
import type { Ball } from './bounds.js';
import { descent, flightKeys } from './flight.js';
import { turnBetween, turned, type Pose, type Turn } from './pose.js';
import { layInRows } from './row-layout.js';
import { minus, plus, times as scaled, type Vector } from './vector.js';

/** When all pieces are folded. */
export const foldEnd = 0.7;

/** Where a piece is: poses at ascending times, between which it moves straight and turns evenly. */
export interface Track {
  times: number[];
  /** From the piece's sheet into the space of the model. */
  poses: Pose[];
}

/** Width over height of most screens. */
const usualAspect = 1.6;

/** Room between pieces, as a share of the model's radius. */
const gapShare = 0.1;

/** When a piece rises from the table, and when it has come to its place. */
export function flightTimes(rank: number, pieces: number): { start: number; end: number } {
  // While one piece comes in, the next one rises.
  const every = 1 - descent;
  const duration = (1 - foldEnd) / (every * (pieces - 1) + 1);
  const start = foldEnd + rank * every * duration;
  return { start, end: rank === pieces - 1 ? 1 : start + duration };
}

/**
 * The times at which a person has something to hold: all pieces flat, all folded, and each piece in its place, in the
 * order in which they join.
 */
export function stepTimes(pieces: number): number[] {
  return [
    0,
    foldEnd,
    ...Array.from({ length: pieces }, (_, rank) => flightTimes(rank, pieces).end),
  ];
}

/** How high the pieces rise above the table while they fold. */
function highestOf(bodies: readonly Body[]): number {
  return Math.max(...bodies.map(({ room }) => room.high[2]));
}

/** Lays the pieces on a table so far below the model that nothing gets in the way of the flights. */
function layOnTable(bodies: readonly Body[], model: Ball, table: Turn, aspect: number): Pose[] {
  const boxes = bodies.map(({ room: { low, high } }) => ({
    width: high[0] - low[0],
    height: high[1] - low[1],
  }));
  const spots = layInRows(boxes, aspect, gapShare * model.radius);
  const widest = Math.max(...bodies.map(({ ball }) => ball.radius));
  const depth = model.radius + 2 * widest + highestOf(bodies);
  const middle = minus(model.centre, turned(table, [0, 0, depth]));
  return bodies.map(({ room }, piece) => {
    const { x, y } = spots[piece]!;
    const corner: Vector = [x - room.low[0], y - room.low[1], 0];
    return { turn: table, move: plus(middle, turned(table, corner)) };
  });
}

/**
 * The ways of all pieces in the space of the model. Their folds turn meanwhile as their motions say,
 * stretched over the time until `foldEnd`. Pieces keep clear of each other, except where one is
 * hooked into another so that no straight way leads in.
 *
 * @param model a ball around it
 * @param table turns sheets into the plane on which they lie at first, printed side up
 * @param aspect width over height of what they fill there
 */
export function choreograph(
  bodies: readonly Body[],
  model: Ball,
  table: Turn,
  aspect = usualAspect,
): Track[] {
  const starts = layOnTable(bodies, model, table, aspect);
  const highest = highestOf(bodies);
  const up = turned(table, [0, 0, 1]);
  return bodies.map(({ ball, from, home, rank, room }, piece) => {
    const keys = flightKeys({
      start: starts[piece]!,
      end: home,
      ball,
      model,
      up,
      lift: highest - room.low[2],
      // Nothing is in the way of the first.
      from: rank === 0 ? scaled(up, -1) : from,
    });
    const { start, end } = flightTimes(rank, bodies.length);
    return {
      times: keys.map(({ share }) => (1 - share) * start + share * end),
      poses: keys.map(({ pose }) => pose),
    };
  });
}

/** Where a piece is at a time from 0 to 1. */
export function poseOn({ times, poses }: Track, time: number): Pose {
  const next = times.findIndex((key) => key > time);
  // Before its first key and after its last one it rests.
  if (next <= 0) return poses.at(next)!;
  const [from, to] = [poses[next - 1]!, poses[next]!];
  const share = (time - times[next - 1]!) / (times[next]! - times[next - 1]!);
  return {
    turn: turnBetween(from.turn, to.turn, share),
    move: plus(from.move, scaled(minus(to.move, from.move), share)),
  };
}
