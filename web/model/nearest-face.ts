import type { Triangles } from './file-faces.js';
import type { Vector } from './vector.js';

/** Faces per leaf: fewer make the tree deep, more make each look at one slow. */
const leafSize = 4;

/** The corners of all faces, 9 coordinates each. */
export function cornersOf({ vertices, faces }: Triangles): Float64Array {
  return Float64Array.from(
    { length: 3 * faces.length },
    (_, i) => vertices[3 * faces[Math.floor(i / 3)]! + (i % 3)]!,
  );
}

/** The normal of the face whose corners begin at `at`, as long as twice its area. */
export function normalAt(corners: Float64Array, at: number): Vector {
  const side = (corner: number, axis: number): number =>
    corners[at + 3 * corner + axis]! - corners[at + axis]!;
  const [ux, uy, uz] = [side(1, 0), side(1, 1), side(1, 2)];
  const [vx, vy, vz] = [side(2, 0), side(2, 1), side(2, 2)];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

/**
 * Sets shares of the second and third corner at the point of a triangle that is nearest to another one.
 *
 * @param corners of triangles, of which this one's begin at `at`
 */
export function nearestShares(
  [x, y, z]: Vector,
  corners: Float64Array,
  at: number,
  shares: Float64Array,
): void {
  // Ericson, Real-Time Collision Detection, 5.1.5: the corners first, then the sides, then within.
  const [px, py, pz] = [corners[at]!, corners[at + 1]!, corners[at + 2]!];
  const [qx, qy, qz] = [corners[at + 3]! - px, corners[at + 4]! - py, corners[at + 5]! - pz];
  const [rx, ry, rz] = [corners[at + 6]! - px, corners[at + 7]! - py, corners[at + 8]! - pz];
  const [dx, dy, dz] = [x - px, y - py, z - pz];
  const d1 = qx * dx + qy * dy + qz * dz;
  const d2 = rx * dx + ry * dy + rz * dz;
  const [qq, qr, rr] = [
    qx * qx + qy * qy + qz * qz,
    qx * rx + qy * ry + qz * rz,
    rx * rx + ry * ry + rz * rz,
  ];
  // The same products from the second and from the third corner.
  const [d3, d4, d5, d6] = [d1 - qq, d2 - qr, d1 - qr, d2 - rr];
  const [onQ, onR, between] = [d1 * d4 - d3 * d2, d5 * d2 - d1 * d6, d3 * d6 - d5 * d4];
  let [b, c] = [0, 0];
  if (d1 <= 0 && d2 <= 0) [b, c] = [0, 0];
  else if (d3 >= 0 && d4 <= d3) b = 1;
  else if (onQ <= 0 && d1 >= 0 && d3 <= 0) b = d1 / (d1 - d3);
  else if (d6 >= 0 && d5 <= d6) c = 1;
  else if (onR <= 0 && d2 >= 0 && d6 <= 0) c = d2 / (d2 - d6);
  else if (between <= 0 && d4 >= d3 && d5 >= d6) {
    c = (d4 - d3) / (d4 - d3 + (d5 - d6));
    b = 1 - c;
  } else {
    const sum = between + onR + onQ;
    [b, c] = [onR / sum, onQ / sum];
  }
  shares[0] = b;
  shares[1] = c;
}

/** The nearest place of a surface. */
export interface NearestPlace {
  face: number;
  /** Shares of its second and third corner. */
  b: number;
  c: number;
}

/** Boxes around boxes around faces, in which the nearest one to a point is found. */
export class NearestFace {
  /** Faces in the order of the leaves. */
  private readonly order: Int32Array;
  /** 6 per node: its least and largest coordinates. */
  private readonly boxes: Float64Array;
  /** Per node: where its faces begin and end in `order`, and its second child, 0 for a leaf. */
  private readonly nodes: { from: number; to: number; second: number }[] = [];
  private readonly corners: Float64Array;
  private readonly shares = new Float64Array(2);
  private best = Infinity;
  private place: NearestPlace = { face: -1, b: 0, c: 0 };

  /** Takes n log² n steps for n faces. */
  constructor(surface: Triangles) {
    this.corners = cornersOf(surface);
    this.order = Int32Array.from({ length: surface.faces.length / 3 }, (_, face) => face);
    const boxes: number[] = [];
    this.build(0, this.order.length, boxes);
    this.boxes = Float64Array.from(boxes);
  }

  /**
   * The nearest place to a point on a face that looks the same way as `normal`; null if none does.
   *
   * @param hint a face that may be near: the nearer it is, the quicker the search
   */
  find(point: Vector, normal: Vector, hint: number): NearestPlace | null {
    this.best = Infinity;
    this.place = { face: -1, b: 0, c: 0 };
    if (hint >= 0) this.tryFace(hint, point, normal);
    this.descend(0, point, normal);
    return this.place.face < 0 ? null : this.place;
  }

  /** The way from a point to the surface, whichever way that looks; `most` if it is longer. */
  distance(point: Vector, most: number): number {
    this.best = most * most;
    this.place = { face: -1, b: 0, c: 0 };
    this.descend(0, point, null);
    return Math.sqrt(this.best);
  }

  private build(from: number, to: number, boxes: number[]): void {
    const box = this.boxAround(from, to);
    const node = { from, to, second: 0 };
    this.nodes.push(node);
    for (const value of box) boxes.push(value);
    if (to - from <= leafSize) return;
    const sizes = [0, 1, 2].map((axis) => box[axis + 3]! - box[axis]!);
    const axis = sizes.indexOf(Math.max(...sizes));
    const { corners } = this;
    const centre = (face: number): number =>
      corners[9 * face + axis]! + corners[9 * face + 3 + axis]! + corners[9 * face + 6 + axis]!;
    this.order.subarray(from, to).sort((one, other) => centre(one) - centre(other) || one - other);
    const middle = (from + to) >> 1;
    this.build(from, middle, boxes);
    node.second = this.nodes.length;
    this.build(middle, to, boxes);
  }

  private boxAround(from: number, to: number): number[] {
    const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    for (let i = from; i < to; ++i) {
      for (let j = 0; j < 9; ++j) {
        const value = this.corners[9 * this.order[i]! + j]!;
        const axis = j % 3;
        box[axis] = Math.min(box[axis]!, value);
        box[axis + 3] = Math.max(box[axis + 3]!, value);
      }
    }
    return box;
  }

  /** Square of the way from a point to a node's box. */
  private wayTo(node: number, point: Vector): number {
    const { boxes } = this;
    const [x, y, z] = point;
    const at = 6 * node;
    const dx = Math.max(boxes[at]! - x, x - boxes[at + 3]!, 0);
    const dy = Math.max(boxes[at + 1]! - y, y - boxes[at + 4]!, 0);
    const dz = Math.max(boxes[at + 2]! - z, z - boxes[at + 5]!, 0);
    return dx * dx + dy * dy + dz * dz;
  }

  private descend(node: number, point: Vector, normal: Vector | null): void {
    const { from, to, second } = this.nodes[node]!;
    if (second === 0) {
      for (let i = from; i < to; ++i) this.tryFace(this.order[i]!, point, normal);
      return;
    }
    const [one, other] = [this.wayTo(node + 1, point), this.wayTo(second, point)];
    const isOrdered = one <= other;
    const [near, far] = isOrdered ? [node + 1, second] : [second, node + 1];
    if (Math.min(one, other) < this.best) this.descend(near, point, normal);
    if (Math.max(one, other) < this.best) this.descend(far, point, normal);
  }

  private tryFace(face: number, point: Vector, normal: Vector | null): void {
    const { corners, shares } = this;
    const at = 9 * face;
    nearestShares(point, corners, at, shares);
    const [b, c] = [shares[0]!, shares[1]!];
    let square = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const [p, q, r] = [corners[at + axis]!, corners[at + 3 + axis]!, corners[at + 6 + axis]!];
      const way = point[axis]! - p - b * (q - p) - c * (r - p);
      square += way * way;
    }
    if (square >= this.best || (normal && !this.looksAlong(face, normal))) return;
    this.best = square;
    this.place = { face, b, c };
  }

  private looksAlong(face: number, [x, y, z]: Vector): boolean {
    const [u, v, w] = normalAt(this.corners, 9 * face);
    return x * u + y * v + z * w > 0;
  }
}
