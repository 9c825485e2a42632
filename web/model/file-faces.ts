/** Finds the faces of a file again in the triangles that were made of them. */
import { boxOf, extentsOf } from './bounds.js';
import type { FileNets } from './file-nets.js';
import type { Up } from './job-options.js';
import { SamePlaces } from './same-places.js';

/** Of the longest side of the model: far above the rounding of floats, far below any edge. */
const samePlace = 1e-5;

/** Points with the middle of their box at the origin, as the engine and files have it at different places. */
function centred(points: ArrayLike<number>): Float64Array {
  const { low, high } = boxOf(points);
  return Float64Array.from(points, (value, i) => value - (low[i % 3]! + high[i % 3]!) / 2);
}

/** A repaired model, y up. */
export interface Triangles {
  /** 3 per vertex. */
  vertices: ArrayLike<number>;
  /** 3 per triangle. */
  faces: ArrayLike<number>;
}

/** Coordinates of a file as the engine turns them, so that y is up. */
function upright(positions: Float64Array, up: Up): Float64Array {
  const turned = positions.slice();
  for (let i = 0; i < turned.length; i += 3) {
    const [x, y, z] = [positions[i]!, positions[i + 1]!, positions[i + 2]!];
    if (up === 'z') turned.set([x, z, -y], i);
    if (up === 'x') turned.set([-y, x, z], i);
  }
  return turned;
}

export class FileFaces {
  /** Per vertex of the model and of the file: the number of its place. */
  private readonly placeOf: Int32Array;
  private readonly filePlaces: Int32Array;
  /** Corners by their face and the places at both ends of their edge. */
  private readonly corners = new Map<string, number>();
  private readonly facesAt = new Map<number, number[]>();
  private readonly touched = new Set<string>();

  /** @param up axis of the file that points up */
  constructor(
    private readonly nets: FileNets,
    private readonly model: Triangles,
    up: Up,
  ) {
    const places = new SamePlaces(
      samePlace * Math.max(...extentsOf(model.vertices), Number.MIN_VALUE),
    );
    const numbers = (points: ArrayLike<number>): Int32Array => {
      const middle = centred(points);
      return Int32Array.from({ length: middle.length / 3 }, (_, i) => places.of(middle, i));
    };
    this.placeOf = numbers(model.vertices);
    this.filePlaces = numbers(upright(nets.positions, up));
    for (let face = 0; face + 1 < nets.firstCorners.length; ++face) this.enter(face);
  }

  /** Per triangle: the face of the file that it is a share of; null if some is a share of none. */
  ofTriangles(): Int32Array | null {
    const { faces } = this.model;
    const found = Int32Array.from({ length: faces.length / 3 }, (_, triangle) => {
      return this.faceOf([0, 1, 2].map((i) => this.placeOf[faces[3 * triangle + i]!]!));
    });
    return found.includes(-1) ? null : found;
  }

  /** The corner of a file's face at whose edge two vertices of the model lie; -1 inside the face. */
  cornerAt(face: number, [from, to]: readonly [number, number]): number {
    const [a, b] = [this.placeOf[from]!, this.placeOf[to]!];
    return this.corners.get(`${face} ${a} ${b}`) ?? this.corners.get(`${face} ${b} ${a}`) ?? -1;
  }

  private enter(face: number): void {
    const { firstCorners, vertices } = this.nets;
    const [begin, end] = [firstCorners[face]!, firstCorners[face + 1]!];
    for (let corner = begin; corner < end; ++corner) {
      const next = corner + 1 < end ? corner + 1 : begin;
      const [place, after] = [corner, next].map((at) => this.filePlaces[vertices[at]!]!);
      this.corners.set(`${face} ${place!} ${after!}`, corner);
      this.touched.add(`${face} ${place!}`);
      const others = this.facesAt.get(place!);
      if (others) others.push(face);
      else this.facesAt.set(place!, [face]);
    }
  }

  /** Of faces that lie on each other, as back and front do, the one that runs the same way round. */
  private faceOf(places: readonly number[]): number {
    const found = (this.facesAt.get(places[0]!) ?? []).filter((face) =>
      places.every((place) => this.touched.has(`${face} ${place}`)),
    );
    const alike = found.find((face) =>
      places.some((place, i) => this.corners.has(`${face} ${place} ${places[(i + 1) % 3]!}`)),
    );
    return alike ?? found[0] ?? -1;
  }
}
