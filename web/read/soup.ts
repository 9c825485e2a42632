import { determinant, mapped, stretch, type Affine } from './matrix.js';
import { unreadable } from './unreadable.js';

/** Far above what a search takes, and what the engine has memory for. */
export const mostTriangles = 4_000_000;

/** How triangles look. */
export interface PartLooks {
  /** 2 per vertex: its place in pictures, to the right and up; NaN for one without. Null if none has one. */
  places: Float32Array | null;
  /** 3 per vertex: red, green and blue (sRGB). Null if none has a colour of its own. */
  colours: Uint8Array | null;
  /** Per triangle: number of its material, -1 for none. Null if none has one. */
  materials: Int32Array | null;
}

/** Triangles in coordinates of their own. */
export interface Part {
  /** 3 per vertex. */
  positions: ArrayLike<number>;
  /** 3 per triangle, all of them vertices. */
  triangles: ArrayLike<number>;
  /** Largest rounding error of a coordinate; 0 for exact ones. */
  error: number;
  looks?: PartLooks;
}

const plain: PartLooks = { places: null, colours: null, materials: null };

interface PlacedPart {
  positions: Float64Array;
  triangles: ArrayLike<number>;
  turned: boolean;
  looks: PartLooks;
}

/** Numbers that a part has in each list of looks. */
const lengths: Readonly<Record<keyof PartLooks, (part: PlacedPart) => number>> = {
  places: ({ positions }) => (2 * positions.length) / 3,
  colours: ({ positions }) => positions.length,
  materials: ({ triangles }) => triangles.length / 3,
};

/** Triangles of a whole model, as its parts are placed in it. Nothing is welded. */
export class Soup {
  private readonly parts: PlacedPart[] = [];
  private triangles = 0;
  private vertices = 0;
  private largestError = 0;

  /** Adds a part; a map that mirrors turns its triangles, so that their outsides stay outside. */
  add({ positions, triangles, error, looks = plain }: Part, map: Affine): void {
    this.triangles += triangles.length / 3;
    if (this.triangles > mostTriangles) {
      throw unreadable('too-many-triangles', { most: mostTriangles });
    }
    const placed = mapped(map, positions);
    const strange = placed.findIndex((value) => !Number.isFinite(value));
    if (strange !== -1) {
      const at = this.vertices + Math.floor(strange / 3);
      throw unreadable('not-finite', { what: 'coordinate', place: 'vertex', at });
    }
    this.vertices += positions.length / 3;
    this.largestError = Math.max(this.largestError, error * stretch(map));
    this.parts.push({ positions: placed, triangles, turned: determinant(map) < 0, looks });
  }

  get triangleCount(): number {
    return this.triangles;
  }

  /** Largest rounding error of a coordinate that its source explains. */
  get error(): number {
    return this.largestError;
  }

  /** 3 per vertex. */
  positions(): Float64Array {
    const all = new Float64Array(3 * this.vertices);
    let at = 0;
    for (const { positions } of this.parts) {
      all.set(positions, at);
      at += positions.length;
    }
    return all;
  }

  /** 3 per triangle. */
  corners(): Int32Array {
    const all = new Int32Array(3 * this.triangles);
    let [at, first] = [0, 0];
    for (const { positions, triangles, turned } of this.parts) {
      for (let i = 0; i < triangles.length; i += 3) {
        all[at++] = first + triangles[i]!;
        all[at++] = first + triangles[turned ? i + 2 : i + 1]!;
        all[at++] = first + triangles[turned ? i + 1 : i + 2]!;
      }
      first += positions.length / 3;
    }
    return all;
  }

  /** As those of its parts; white where a part has no colours. */
  looks(): PartLooks {
    const { vertices, triangles } = this;
    return {
      places: this.joined('places', () => new Float32Array(2 * vertices).fill(NaN)),
      colours: this.joined('colours', () => new Uint8Array(3 * vertices).fill(255)),
      materials: this.joined('materials', () => new Int32Array(triangles).fill(-1)),
    };
  }

  /** The lists of all parts in a row, in one that is filled with what stands for none. */
  private joined<List extends Float32Array | Uint8Array | Int32Array>(
    name: keyof PartLooks,
    make: () => List,
  ): List | null {
    if (this.parts.every(({ looks }) => looks[name] === null)) return null;
    const all = make();
    let at = 0;
    for (const part of this.parts) {
      const values = part.looks[name];
      if (values) all.set(values, at);
      at += lengths[name](part);
    }
    return all;
  }
}
