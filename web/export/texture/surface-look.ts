import type { Looks, Material } from '../../model/looks.js';
import { dot, length, minus, vectorAt, type Vector } from '../../model/vector.js';
import { lightOf, shownOf } from '../../model/srgb.js';
import { footprintOf } from './footprint.js';
import type { Raster } from './raster.js';
import { Sampler, type Footprint } from './sampler.js';

/** Vertices, 3 each in mm, and faces, 3 vertices each. */
export interface Surface {
  vertices: Float64Array;
  faces: Int32Array;
}

/** x and y of three corners, from the picture's upper left in its pixels. */
type Corners = [number, number, number, number, number, number];

/** What a material shows, and where corners of a face lie in its picture. */
interface PicturePlace {
  sampler: Sampler;
  footprint: Footprint;
  corners: Corners;
}

const white: readonly [number, number, number] = [255, 255, 255];

/** Places so many pixels beyond a picture are errors of a file; single precision could not tell neighbours apart there. */
const farthest = 1e9;

/** Light of each value that a colour of a corner can have. */
const lights = Float64Array.from({ length: 256 }, (_, value) => lightOf(value / 255));

/** A face in its plane: the length of its first side, and the third corner along and beside it; mm. */
function flatten({ vertices, faces }: Surface, face: number): [number, number, number] {
  const corner = (i: number): Vector => vectorAt(vertices, faces[3 * face + i]!);
  const [first, second] = [minus(corner(1), corner(0)), minus(corner(2), corner(0))];
  const size = length(first);
  const along = size > 0 ? dot(first, second) / size : 0;
  return [size, along, Math.sqrt(Math.max(0, dot(second, second) - along * along))];
}

/** Where the corners of a face lie in its picture; null if nothing says it. */
function cornersOf(
  places: Float32Array,
  face: number,
  { scale, offset }: Material,
  { width, height }: Sampler,
): Corners | null {
  const at = (corner: number, axis: 0 | 1): number =>
    scale[axis] * places[6 * face + 2 * corner + axis]! + offset[axis];
  const corners = [0, 1, 2].flatMap((corner) => [
    width * at(corner, 0),
    height * (1 - at(corner, 1)),
  ]);
  return corners.every((value) => Math.abs(value) < farthest) ? (corners as Corners) : null;
}

/** Tells the colour of any point of a surface. */
export class SurfaceLook {
  private readonly samplers: (Sampler | null)[];
  /** By face; none before it was first asked for. */
  private readonly placed = new Map<number, PicturePlace | null>();

  /**
   * @param surface that the looks are of
   * @param pictures by number; null for those that are not to be had
   * @param dot width of a dot of paper in mm
   */
  constructor(
    private readonly surface: Surface,
    private readonly looks: Looks,
    pictures: readonly (Raster | null)[],
    private readonly dot: number,
  ) {
    this.samplers = looks.materials.map(({ picture, wrap }) => {
      const raster = picture === null ? null : (pictures[picture] ?? null);
      return raster && new Sampler(raster, wrap);
    });
  }

  /**
   * The colour of a point of a face.
   *
   * @param b the share of its second corner, and `c` that of its third
   * @param colour gets red, green and blue, 0 to 255
   */
  colourAt(face: number, b: number, c: number, colour: Float64Array): void {
    const a = 1 - b - c;
    colour.set(this.looks.materials[this.materialNumber(face)]?.colour ?? white);
    this.tintByCorners(face, b, c, colour);
    const place = this.placeOf(face);
    if (!place) return;
    const { sampler, footprint, corners } = place;
    const x = a * corners[0] + b * corners[2] + c * corners[4];
    const y = a * corners[1] + b * corners[3] + c * corners[5];
    sampler.tint(x, y, footprint, colour);
  }

  /** Colours between corners mix as light does, on paper as on the screen and in other programs. */
  private tintByCorners(face: number, b: number, c: number, colour: Float64Array): void {
    const { colours } = this.looks.surface;
    if (!colours) return;
    for (let i = 0; i < 3; ++i) {
      const at = 9 * face + i;
      const [first, second, third] = [colours[at]!, colours[at + 3]!, colours[at + 6]!];
      if (first === second && second === third) colour[i]! *= first / 255;
      else {
        const light = (1 - b - c) * lights[first]! + b * lights[second]! + c * lights[third]!;
        colour[i]! *= shownOf(light);
      }
    }
  }

  private materialNumber(face: number): number {
    return this.looks.surface.materials?.[face] ?? -1;
  }

  private placeOf(face: number): PicturePlace | null {
    const known = this.placed.get(face);
    if (known !== undefined) return known;
    const place = this.findPlace(face);
    this.placed.set(face, place);
    return place;
  }

  private findPlace(face: number): PicturePlace | null {
    const number = this.materialNumber(face);
    const sampler = this.samplers[number];
    const { places } = this.looks.surface;
    if (!sampler || !places) return null;
    const corners = cornersOf(places, face, this.looks.materials[number]!, sampler);
    return corners && { sampler, corners, footprint: this.footprintOn(face, corners) };
  }

  private footprintOn(face: number, [x0, y0, x1, y1, x2, y2]: Corners): Footprint {
    const [length, along, beside] = flatten(this.surface, face);
    if (length === 0 || beside === 0) return footprintOf([0, 0, 0, 0]);
    const [xr, yr] = [(x1 - x0) / length, (y1 - y0) / length];
    const [xu, yu] = [(x2 - x0 - along * xr) / beside, (y2 - y0 - along * yr) / beside];
    return footprintOf([xr * this.dot, yr * this.dot, xu * this.dot, yu * this.dot]);
  }
}
