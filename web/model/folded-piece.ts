import { anglesAt } from './fold-motion.js';
import type { FoldTree } from './fold-tree.js';
import type { Model, Piece } from './job.js';
import { atOrigin, poseAfter, posed, poseOnto, turnAbout, turnAround, type Pose } from './pose.js';
import { direction, minus, vectorAt, type Vector } from './vector.js';

/** A vertex of a piece on its sheet: the printed side looks along z. */
export function flatVertex({ vertices }: Piece, vertex: number): Vector {
  return [vertices[2 * vertex]!, vertices[2 * vertex + 1]!, 0];
}

/** Where a face hangs: a point of the edge, and its direction as the face is walked. */
export function hingeOf(
  piece: Piece,
  tree: FoldTree,
  face: number,
): { point: Vector; axis: Vector } {
  const corner = tree.corners[face]!;
  const from = flatVertex(piece, piece.faces[3 * face + corner]!);
  const to = flatVertex(piece, piece.faces[3 * face + ((corner + 1) % 3)]!);
  return { point: from, axis: direction(minus(to, from)) };
}

/**
 * The rigid motion of every face from the sheet to its place at a time from 0 (flat) to 1 (folded);
 * the root stays on the sheet. A valley turns a face up around the edge as the face walks it.
 */
export function facePoses(piece: Piece, tree: FoldTree, time: number): Pose[] {
  const angles = anglesAt(piece, time);
  const poses: Pose[] = [];
  for (const face of tree.order) {
    const parent = tree.parents[face]!;
    if (parent < 0) {
      poses[face] = atOrigin;
      continue;
    }
    const { point, axis } = hingeOf(piece, tree, face);
    const angle = (angles[tree.edges[face]!]! * Math.PI) / 180;
    poses[face] = poseAfter(poses[parent]!, turnAbout(point, turnAround(axis, angle)));
  }
  return poses;
}

/** All vertices of a piece at such a time, 3 numbers each; see `facePoses`. */
export function foldedVertices(piece: Piece, tree: FoldTree, time: number): Float64Array {
  const folded = new Float64Array((3 * piece.vertices.length) / 2);
  // Faces that share a vertex hang together by folds through it: all of them take it to one place.
  facePoses(piece, tree, time).forEach((pose, face) => {
    for (let at = 3 * face; at < 3 * face + 3; ++at) {
      const vertex = piece.faces[at]!;
      folded.set(posed(pose, flatVertex(piece, vertex)), 3 * vertex);
    }
  });
  return folded;
}

/** The pose that takes the root of a piece from its sheet to its place in the model. */
export function modelPose(piece: Piece, { order }: FoldTree, model: Model): Pose {
  const root = order[0]!;
  const source = piece.sources[root]!;
  const corners = [0, 1, 2];
  return poseOnto(
    corners.map((corner) => flatVertex(piece, piece.faces[3 * root + corner]!)),
    corners.map((corner) => vectorAt(model.vertices, model.faces[3 * source + corner]!)),
  );
}
