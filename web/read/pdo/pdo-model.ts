/** Puts the bodies of a PDO file together to one model. */
import type { LookedFiles } from '../../model/looks.js';
import type { FileNets } from '../../model/file-nets.js';
import { mostTriangles } from '../soup.js';
import { unreadable } from '../unreadable.js';
import type { Polygons } from '../polygon-file.js';
import type { PdoPattern } from './pdo-pattern.js';
import type { PdoObject } from './pdo-objects.js';

/** Gathers the faces that can be used, and counts the others. */
export class PdoModel {
  private readonly positions: number[] = [];
  private readonly firstCorners: number[] = [0];
  private readonly vertices: number[] = [];
  private readonly places: number[] = [];
  private readonly materials: number[] = [];
  private readonly joined: number[] = [];
  private readonly flaps: number[] = [];
  /** Faces that lack corners, or name vertices that there are not. */
  broken = 0;
  /** Bodies that are switched off. */
  hidden = 0;

  add(object: PdoObject): void {
    if (!object.isVisible) {
      ++this.hidden;
      return;
    }
    const joined = joinedCorners(object);
    const numbers = new Map<number, number>();
    const { firstCorners, materials } = object;
    materials.forEach((material, face) => {
      const [begin, end] = [firstCorners[face]!, firstCorners[face + 1]!];
      if (!isUsable(object, begin, end)) {
        ++this.broken;
        return;
      }
      for (let corner = begin; corner < end; ++corner) this.addCorner(object, corner, numbers);
      for (let corner = begin; corner < end; ++corner) {
        this.joined.push(joined.has(corner) ? 1 : 0);
      }
      this.materials.push(material);
      this.firstCorners.push(this.vertices.length);
    });
    const triangles = this.vertices.length - 2 * this.materials.length;
    if (triangles > mostTriangles) throw unreadable('too-many-triangles', { most: mostTriangles });
  }

  /** Faces with the numbers of their materials, as far as there are such. */
  polygons({ materials: known, pictures }: LookedFiles): Polygons {
    const { positions, firstCorners, vertices } = this;
    const places = pictures.length > 0 ? this.places : null;
    const materials = this.materials.map((number) => (number in known ? number : -1));
    return { positions, firstCorners, vertices, materials, places };
  }

  /** Null where nothing is joined, so that there are as many nets as faces. */
  nets({ scale, parts }: PdoPattern): FileNets | null {
    if (!this.joined.includes(1)) return null;
    return {
      positions: Float64Array.from(this.positions),
      firstCorners: Int32Array.from(this.firstCorners),
      vertices: Int32Array.from(this.vertices),
      joined: Uint8Array.from(this.joined),
      flaps: Float64Array.from(this.flaps),
      scale,
      pieces: parts,
    };
  }

  private addCorner(object: PdoObject, corner: number, numbers: Map<number, number>): void {
    const { vertices, places, flaps } = object.corners;
    const vertex = vertices[corner]!;
    let number = numbers.get(vertex);
    if (number === undefined) {
      number = this.positions.length / 3;
      for (let axis = 0; axis < 3; ++axis) {
        this.positions.push(object.positions[3 * vertex + axis]!);
      }
      numbers.set(vertex, number);
    }
    this.vertices.push(number);
    const [across, down] = [places[2 * corner]!, places[2 * corner + 1]!];
    // The file counts from the upper edge.
    this.places.push(across, 1 - down);
    this.flaps.push(flaps[corner]!);
  }
}

function isUsable({ corners, positions }: PdoObject, begin: number, end: number): boolean {
  if (end - begin < 3) return false;
  const count = positions.length / 3;
  for (let corner = begin; corner < end; ++corner) {
    const vertex = corners.vertices[corner]!;
    if (vertex < 0 || vertex >= count) return false;
    for (let axis = 0; axis < 3; ++axis) {
      if (!Number.isFinite(positions[3 * vertex + axis]!)) return false;
    }
  }
  return true;
}

/** Corners of an object at whose edge the net goes on. */
function joinedCorners({
  corners,
  joined,
  firstCorners,
  materials,
  positions,
}: PdoObject): Set<number> {
  const found = new Set<number>();
  if (joined.length === 0) return found;
  const keyOf = (face: number, vertex: number): number => face * positions.length + vertex;
  const cornerOf = new Map<number, number>();
  materials.forEach((_, face) => {
    for (let corner = firstCorners[face]!; corner < firstCorners[face + 1]!; ++corner) {
      cornerOf.set(keyOf(face, corners.vertices[corner]!), corner);
    }
  });
  for (let at = 0; at < joined.length; at += 4) {
    const [one, other, from, to] = joined.subarray(at, at + 4);
    // The edge runs the other way in its second face.
    const sides = [cornerOf.get(keyOf(one!, from!)), cornerOf.get(keyOf(other!, to!))];
    for (const corner of sides) if (corner !== undefined) found.add(corner);
  }
  return found;
}
