import { cornersOf, NearestFace, normalAt } from '../../model/nearest-face.js';
import type { PaintPlan } from './paint-plan.js';
import { shadeAt, shadesOf } from './shading.js';
import { SurfaceLook, type Surface } from './surface-look.js';

/** The colour of a face at shares of its second and third corner; the array is used again. */
export type FaceColour = (b: number, c: number) => Float64Array;

/** Tells the colours of the model's faces, from its own surface or from the one before it was simplified. */
export class SurfaceMap {
  private readonly look: SurfaceLook | null;
  /** Three per face of the surface that is shown; null if it has no light of its own. */
  private readonly shades: Float32Array | null;
  private readonly original: NearestFace | null;
  private readonly model: Surface;
  private readonly colour = new Float64Array(3);

  constructor({ model, original, looks, pictures, dpi, isShaded }: PaintPlan) {
    const shown = original ?? model;
    this.model = model;
    this.look = looks && new SurfaceLook(shown, looks, pictures, 25.4 / dpi);
    this.shades = isShaded ? shadesOf(shown) : null;
    this.original = original && new NearestFace(original);
  }

  /** @param plain where the surface has no looks */
  lookOf(face: number, plain: readonly number[]): FaceColour {
    const { original } = this;
    if (original) return this.lookOnOriginal(face, original, plain);
    return (b, c) => this.colourAt(face, b, c, plain);
  }

  private colourAt(face: number, b: number, c: number, plain: readonly number[]): Float64Array {
    const { colour, look, shades } = this;
    if (look) look.colourAt(face, b, c, colour);
    else colour.set(plain);
    if (!shades) return colour;
    const shade = shadeAt(shades, face, b, c);
    for (let i = 0; i < 3; ++i) colour[i]! *= shade;
    return colour;
  }

  /** What lies nearest on the original, of all that looks the same way. */
  private lookOnOriginal(
    face: number,
    original: NearestFace,
    plain: readonly number[],
  ): FaceColour {
    const { colour, model } = this;
    const corners = cornersOf({ ...model, faces: model.faces.subarray(3 * face, 3 * face + 3) });
    const normal = normalAt(corners, 0);
    let hint = -1;
    return (b, c) => {
      const a = 1 - b - c;
      const x = a * corners[0]! + b * corners[3]! + c * corners[6]!;
      const y = a * corners[1]! + b * corners[4]! + c * corners[7]!;
      const z = a * corners[2]! + b * corners[5]! + c * corners[8]!;
      const place = original.find([x, y, z], normal, hint);
      if (!place) return colour.fill(255);
      hint = place.face;
      return this.colourAt(place.face, place.b, place.c, plain);
    };
  }
}
