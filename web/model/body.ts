import { ballOf, boxOf, type Ball, type Box3 } from './bounds.js';
import type { FoldTree } from './fold-tree.js';
import { foldedVertices, modelPose } from './folded-piece.js';
import type { Model, Piece } from './job.js';
import { joinOrder } from './join-order.js';
import { posed, type Pose } from './pose.js';
import { vectorAt, type Vector } from './vector.js';
import type { Triangles } from './facing.js';
import { wayOut } from './way-out.js';

/** What the way of a piece into the model depends on. */
export interface Body {
  /** Around all its shapes on its sheet, from flat to folded. */
  room: Box3;
  /** Around the folded piece on its sheet. */
  ball: Ball;
  /** Its pose in the model. */
  home: Pose;
  /** How many pieces come before it. */
  rank: number;
  /** The direction from which it comes in, past those before it. */
  from: Vector;
}

/** Times at which a piece is looked at to know how much room it takes while it folds. */
const looks = [0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1];

function facesAt(home: Pose, { faces }: Piece, vertices: Float64Array): Triangles {
  const triangles = new Float64Array(3 * faces.length);
  faces.forEach((vertex, at) => triangles.set(posed(home, vectorAt(vertices, vertex)), 3 * at));
  return triangles;
}

function joined(parts: readonly Triangles[]): Triangles {
  const all = new Float64Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/**
 * Looks at all pieces, folded and while they fold, and for their ways into the model in the order of
 * `joinOrder`. Costs some tenths of a second for a thousand faces.
 */
export function bodiesOf(
  { pieces, model }: { pieces: readonly Piece[]; model: Model },
  trees: readonly FoldTree[],
): Body[] {
  const bodies: Body[] = [];
  const before: Triangles[] = [];
  joinOrder(pieces).forEach(({ piece: index }, rank) => {
    const [piece, tree] = [pieces[index]!, trees[index]!];
    const shapes = looks.map((time) => foldedVertices(piece, tree, time));
    const folded = shapes.at(-1)!;
    const home = modelPose(piece, tree, model);
    const faces = facesAt(home, piece, folded);
    const from = wayOut(faces, joined(before));
    bodies[index] = { room: boxOf(...shapes), ball: ballOf(folded), home, rank, from };
    before.push(faces);
  });
  return bodies;
}
