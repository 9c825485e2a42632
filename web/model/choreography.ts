/**
 * How pieces that lie side by side become the model, over a time from 0 to 1: until `foldEnd` each
 * folds up where it lies, then one after the other flies to its place.
 */
import { ballOf, boxOf, type Ball, type Box3 } from './bounds.js';
import { descent, flightKeys } from './flight.js';
import type { FoldTree } from './fold-tree.js';
import { foldedVertices, modelPose } from './folded-piece.js';
import type { JobResult, Model, Piece } from './job.js';
import { joinOrder } from './join-order.js';
import { posed, turnBetween, turned, type Pose, type Turn } from './pose.js';
import { layInRows } from './row-layout.js';
import { minus, plus, times as scaled, vectorAt, type Vector } from './vector.js';
import { wayOut, type Triangles } from './way-out.js';

/** When all pieces are folded. */
export const foldEnd = 0.7;

/** Where a piece is: poses at ascending times, between which it moves straight and turns evenly. */
export interface Track {
  times: number[];
  /** From the piece's sheet into the space of the model. */
  poses: Pose[];
}

/** Times at which a piece is looked at to know how much room it takes while it folds. */
const looks = [0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1];

/** Width over height of the table on which the pieces lie: that of most screens. */
const tableAspect = 1.6;

/** Room between pieces, as a share of the model's radius. */
const gapShare = 0.1;

/** What the way of a piece depends on. */
interface Body {
  /** Around all its shapes on its sheet. */
  room: Box3;
  /** Around the folded piece on its sheet. */
  ball: Ball;
  /** Its pose in the model, and its faces there. */
  home: Pose;
  faces: Triangles;
}

function bodyOf(piece: Piece, tree: FoldTree, model: Model): Body {
  const shapes = looks.map((time) => foldedVertices(piece, tree, time));
  const folded = shapes.at(-1)!;
  const home = modelPose(piece, tree, model);
  const faces = new Float64Array(3 * piece.faces.length);
  piece.faces.forEach((vertex, at) => {
    faces.set(posed(home, vectorAt(folded, vertex)), 3 * at);
  });
  return { room: boxOf(...shapes), ball: ballOf(folded), home, faces };
}

/** How high the pieces rise above the table while they fold. */
function highestOf(bodies: readonly Body[]): number {
  return Math.max(...bodies.map(({ room }) => room.high[2]));
}

/** Lays the pieces on a table so far below the model that nothing gets in the way of the flights. */
function layOnTable(bodies: readonly Body[], model: Ball, table: Turn): Pose[] {
  const boxes = bodies.map(({ room: { low, high } }) => ({
    width: high[0] - low[0],
    height: high[1] - low[1],
  }));
  const spots = layInRows(boxes, tableAspect, gapShare * model.radius);
  const widest = Math.max(...bodies.map(({ ball }) => ball.radius));
  const depth = model.radius + 2 * widest + highestOf(bodies);
  const middle = minus(model.centre, turned(table, [0, 0, depth]));
  return bodies.map(({ room }, piece) => {
    const { x, y } = spots[piece]!;
    const corner: Vector = [x - room.low[0], y - room.low[1], 0];
    return { turn: table, move: plus(middle, turned(table, corner)) };
  });
}

function joinTriangles(parts: readonly Triangles[]): Triangles {
  const all = new Float64Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/**
 * The ways of all pieces in the space of the model, in the order of `joinOrder`. Their folds turn
 * meanwhile as their motions say, stretched over the time until `foldEnd`. Pieces keep clear of each
 * other, except where one is hooked into another so that no straight way leads in.
 *
 * @param table turns sheets into the plane on which they lie at first, printed side up
 */
export function choreograph(
  { pieces, model }: JobResult,
  trees: readonly FoldTree[],
  table: Turn,
): Track[] {
  const modelBall = ballOf(model.vertices);
  const bodies = pieces.map((piece, i) => bodyOf(piece, trees[i]!, model));
  const starts = layOnTable(bodies, modelBall, table);
  const highest = highestOf(bodies);
  // While one piece comes in, the next one rises.
  const duration = (1 - foldEnd) / ((1 - descent) * pieces.length + descent);
  const tracks: Track[] = [];
  const joined: Triangles[] = [];
  joinOrder(pieces).forEach(({ piece }, turn) => {
    const { ball, faces, home, room } = bodies[piece]!;
    const keys = flightKeys({
      start: starts[piece]!,
      end: home,
      ball,
      model: modelBall,
      lift: turned(table, [0, 0, highest - room.low[2]]),
      from: wayOut(faces, joinTriangles(joined)),
    });
    const takeOff = foldEnd + turn * (1 - descent) * duration;
    tracks[piece] = {
      times: keys.map(({ share }) => takeOff + duration * share),
      poses: keys.map(({ pose }) => pose),
    };
    joined.push(faces);
  });
  return tracks;
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
