/** The surface that a result's looks are of, for files that no other program reads. */
import type { JobResult } from '../../web/model/job.js';
import type { Looks } from '../../web/model/looks.js';
import { pngPixels } from './png-pixels.js';
import { lightOf, type TrueSurface } from './true-surface.js';

/** Where corners lie from the upper left of their pictures. */
function placesOf({ surface, materials }: Looks, corners: number): Float64Array {
  return Float64Array.from({ length: 2 * corners }, (_, i) => {
    const material = materials[surface.materials?.[Math.floor(i / 6)] ?? -1];
    const place = surface.places?.[i] ?? NaN;
    if (!material) return NaN;
    const axis = i % 2;
    const moved = material.scale[axis]! * place + material.offset[axis]!;
    return axis === 0 ? moved : 1 - moved;
  });
}

/** @pre all pictures are PNG files */
export function lookedSurface({ model, looks }: JobResult): TrueSurface {
  const { surface, materials, pictures } = looks!;
  const { vertices, faces } = surface.original ?? model;
  const plain = { colour: [1, 1, 1], picture: null, wrap: ['clamp', 'clamp'] } as const;
  return {
    corners: Float64Array.from(
      { length: 3 * faces.length },
      (_, i) => vertices[3 * faces[Math.floor(i / 3)]! + (i % 3)]!,
    ),
    places: placesOf(looks!, faces.length),
    colours: Float64Array.from({ length: 3 * faces.length }, (_, i) =>
      lightOf(surface.colours?.[i] ?? 255),
    ),
    // Those without a material get the last one.
    materials: Int32Array.from({ length: faces.length / 3 }, (_, face) => {
      const material = surface.materials?.[face] ?? -1;
      return material < 0 ? materials.length : material;
    }),
    looks: [
      ...materials.map(({ colour, picture, wrap }) => ({
        colour: colour.map(lightOf) as [number, number, number],
        picture,
        wrap,
      })),
      plain,
    ],
    pictures: pictures.map(({ bytes }) => pngPixels(bytes)),
  };
}
