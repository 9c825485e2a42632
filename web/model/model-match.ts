/** Finds the edges, faces and groups of faces of a model again in a corrected one, by their places. */
import { boxOf } from './bounds.js';
import { areasOf } from './face-areas.js';
import type { EdgeName, Model } from './job.js';
import { diagonalOf, fitOf, nearestVertex, placeTolerance } from './model-fit.js';
import { NearestFace } from './nearest-face.js';
import { cross, length, minus, plus, times, vectorAt, type Vector } from './vector.js';

/** A repaired model in mm, and its millimetres per unit of the file. */
export interface MatchedModel {
  model: Pick<Model, 'vertices' | 'faces'>;
  scale: number;
}

/** A group is found again in one that shares so much of its area with it, and it of the other's. */
const leastShare = 0.5;

function cornersOf({ vertices, faces }: MatchedModel['model'], face: number): Vector[] {
  return [0, 1, 2].map((corner) => vectorAt(vertices, faces[3 * face + corner]!));
}

function middleOf([a, b, c]: readonly Vector[]): Vector {
  return times(plus(plus(a!, b!), c!), 1 / 3);
}

/** For each face of a model the face of another one that it lies on, -1 for none. @param to where points come to lie */
function facesOn(
  from: MatchedModel['model'],
  on: MatchedModel['model'],
  to: (point: Vector) => Vector,
): Int32Array {
  const nearest = new NearestFace(on);
  const tolerance = placeTolerance * diagonalOf(boxOf(on.vertices));
  let hint = -1;
  return Int32Array.from({ length: from.faces.length / 3 }, (_, face) => {
    const [a, b, c] = cornersOf(from, face).map(to);
    const point = middleOf([a!, b!, c!]);
    const place = nearest.find(point, cross(minus(b!, a!), minus(c!, a!)), hint);
    if (!place) return -1;
    hint = place.face;
    const [p, q, r] = cornersOf(on, place.face);
    const there = plus(
      plus(times(p!, 1 - place.b - place.c), times(q!, place.b)),
      times(r!, place.c),
    );
    return length(minus(point, there)) <= tolerance ? place.face : -1;
  });
}

function edgeKey(v: number, w: number, count: number): number {
  return Math.min(v, w) * count + Math.max(v, w);
}

/** What the greatest share of a group lies in; null if that is less than half. */
function mainGroup(areas: ReadonlyMap<number, number>, whole: number): number | null {
  for (const [group, area] of areas) if (area >= leastShare * whole) return group;
  return null;
}

/** Two models of which the second one is the first one corrected. */
export class ModelMatch {
  private readonly vertices = new Map<number, number>();
  private readonly edges = new Set<number>();
  private readonly areas: { before: Float64Array; after: Float64Array };
  /** Per face of the one, the face of the other that it lies on. */
  private readonly ahead: Int32Array;
  private readonly back: Int32Array;
  private readonly toAfter: (point: Vector) => Vector;
  private readonly tolerance: number;

  /** Cost: that of `fitOf`, and a logarithmic search for each face. @pre both have faces */
  constructor(
    private readonly before: MatchedModel,
    private readonly after: MatchedModel,
  ) {
    const sized = ({ model, scale }: MatchedModel) => ({ vertices: model.vertices, scale });
    const fit = fitOf(sized(before), sized(after));
    this.toAfter = (point) => fit.ahead(point);
    this.ahead = facesOn(before.model, after.model, this.toAfter);
    this.back = facesOn(after.model, before.model, (point) => fit.back(point));
    this.areas = { before: areasOf(before.model), after: areasOf(after.model) };
    this.tolerance = placeTolerance * diagonalOf(boxOf(after.model.vertices));
    const { faces, vertices } = after.model;
    faces.forEach((from, corner) => {
      const to = faces[corner % 3 === 2 ? corner - 2 : corner + 1]!;
      this.edges.add(edgeKey(from, to, vertices.length / 3));
    });
  }

  /** The edge that lies where this one was, with its ends in the same order; null if there is none. */
  edge([v, w]: EdgeName): EdgeName | null {
    const [from, to] = [this.vertex(v), this.vertex(w)];
    const count = this.after.model.vertices.length / 3;
    const isThere = from >= 0 && to >= 0 && from !== to && this.edges.has(edgeKey(from, to, count));
    return isThere ? [from, to] : null;
  }

  /** Faces that lie where these were, ascending; null if one of them is gone. */
  faces(faces: readonly number[]): number[] | null {
    const found = new Set<number>();
    for (const face of faces) {
      const other = this.ahead[face] ?? -1;
      if (other < 0) return null;
      found.add(other);
    }
    // Where the model is finer now, several faces lie on one of before.
    const wanted = new Set(faces);
    this.back.forEach((face, other) => {
      if (wanted.has(face)) found.add(other);
    });
    return [...found].sort((a, b) => a - b);
  }

  /**
   * The group of faces that lies where another one was: each has at least half of the other's area.
   *
   * @param before per face of the model before its group
   * @param after the same of the model after it
   */
  group(group: number, before: Int32Array, after: Int32Array): number | null {
    const shares = new Map<number, number>();
    let whole = 0;
    before.forEach((other, face) => {
      if (other !== group) return;
      const area = this.areas.before[face]!;
      whole += area;
      const found = after[this.ahead[face]!] ?? -1;
      if (found >= 0) shares.set(found, (shares.get(found) ?? 0) + area);
    });
    const found = mainGroup(shares, whole);
    return found !== null && this.isMostly(found, after, group, before) ? found : null;
  }

  private isMostly(group: number, after: Int32Array, of: number, before: Int32Array): boolean {
    let [share, whole] = [0, 0];
    after.forEach((other, face) => {
      if (other !== group) return;
      const area = this.areas.after[face]!;
      whole += area;
      if (before[this.back[face]!] === of) share += area;
    });
    return share >= leastShare * whole;
  }

  /** The vertex that lies where this one was, -1 if there is none. */
  private vertex(vertex: number): number {
    const known = this.vertices.get(vertex);
    if (known !== undefined) return known;
    const { vertices } = this.before.model;
    if (3 * vertex >= vertices.length) return -1;
    const point = this.toAfter(vectorAt(vertices, vertex));
    const nearest = nearestVertex(this.after.model.vertices, point);
    const found = nearest.distance <= this.tolerance ? nearest.vertex : -1;
    this.vertices.set(vertex, found);
    return found;
  }
}
