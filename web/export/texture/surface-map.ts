import { cornersOf, NearestFace, normalAt } from '../../model/nearest-face.js';
import type { PaintPlan } from './paint-plan.js';
import { SurfaceLook, type Surface } from './surface-look.js';

/** The colour of a face at shares of its second and third corner; the array is used again. */
export type FaceColour = (b: number, c: number) => Float64Array;

/** Tells the colours of the model's faces, from its own surface or from the one before it was simplified. */
export class SurfaceMap {
  private readonly look: SurfaceLook;
  private readonly original: NearestFace | null;
  private readonly model: Surface;
  private readonly colour = new Float64Array(3);

  constructor({ model, looks, pictures, dpi }: PaintPlan) {
    const { original } = looks.surface;
    this.model = model;
    this.look = new SurfaceLook(original ?? model, looks, pictures, 25.4 / dpi);
    this.original = original && new NearestFace(original);
  }

  lookOf(face: number): FaceColour {
    const { colour, original } = this;
    if (original) return this.lookOnOriginal(face, original);
    return (b, c) => {
      this.look.colourAt(face, b, c, colour);
      return colour;
    };
  }

  /** What lies nearest on the original, of all that looks the same way. */
  private lookOnOriginal(face: number, original: NearestFace): FaceColour {
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
      this.look.colourAt(place.face, place.b, place.c, colour);
      return colour;
    };
  }
}
