import type { GLTF, Primitive } from '@gltf-transform/core';
import type { Material } from '../../model/looks.js';
import type { PartLooks } from '../soup.js';
import { baseColourOf, type BaseColour } from './base-colour.js';
import type { Images } from './images.js';
import { coloursOf, placesOf } from './vertex-looks.js';

/** The looks of all meshes of a glTF file, with the materials that they use. */
export class GltfLooks {
  readonly materials: Material[] = [];
  private readonly numbers = new Map<number, number>();

  constructor(
    private readonly json: GLTF.IGLTF,
    private readonly images: Images,
  ) {}

  /**
   * @param index of the material; undefined for what has none
   * @throws RangeFault where there are other values than vertices
   */
  of(
    primitive: Primitive,
    index: number | undefined,
    { vertices, triangles }: { vertices: number; triangles: number },
  ): PartLooks {
    const base = baseColourOf(this.json, index);
    const { picture } = base;
    return {
      places: picture && placesOf(primitive, picture.places, picture.transform, vertices),
      colours: coloursOf(primitive, vertices),
      materials:
        index === undefined ? null : new Int32Array(triangles).fill(this.numberOf(index, base)),
    };
  }

  private numberOf(index: number, base: BaseColour): number {
    const known = this.numbers.get(index);
    if (known !== undefined) return known;
    const number = this.materials.push(this.materialOf(index, base)) - 1;
    this.numbers.set(index, number);
    return number;
  }

  private materialOf(index: number, { colour, picture }: BaseColour): Material {
    return {
      name: this.json.materials?.[index]?.name ?? `material ${index + 1}`,
      colour,
      picture: picture && this.images.pictureOf(picture.texture),
      wrap: picture ? this.images.wrapOf(picture.texture) : ['repeat', 'repeat'],
      // What the file says of that is in the places already.
      scale: [1, 1],
      offset: [0, 0],
    };
  }
}
