/** How faces are sorted for a picture of a model as its files say that it looks. */
import { describe, expect, it } from 'vitest';
import type { LookedSurface, Material } from '../../web/model/looks.js';
import { faceGroups, writePlaces } from '../../web/view/looked-faces.js';

const material = (picture: number | null): Material => ({
  name: '',
  colour: [255, 255, 255],
  picture,
  wrap: ['repeat', 'repeat'],
  scale: [2, 3],
  offset: [0.5, -1],
});

const surface = (more: Partial<LookedSurface>): LookedSurface => ({
  original: null,
  places: null,
  colours: null,
  materials: null,
  ...more,
});

describe('faces of a model as it looks', () => {
  it('are drawn together if they are of one material', () => {
    const materials = Int32Array.of(1, -1, 1, 0, 7);
    const groups = faceGroups(surface({ materials }), [material(null), material(0)], 5);
    expect(groups).toEqual([
      { material: 1, hasPicture: false, corners: [0, 1, 2, 6, 7, 8] },
      { material: -1, hasPicture: false, corners: [3, 4, 5, 12, 13, 14] },
      { material: 0, hasPicture: false, corners: [9, 10, 11] },
    ]);
    expect(faceGroups(surface({}), [], 2)).toEqual([
      { material: -1, hasPicture: false, corners: [0, 1, 2, 3, 4, 5] },
    ]);
  });

  it('have pictures where all their corners have places', () => {
    const places = Float32Array.from({ length: 12 }, (_, i) => (i === 9 ? NaN : i));
    const given = surface({ places, materials: Int32Array.of(0, 0) });
    const groups = faceGroups(given, [material(0)], 2);
    expect(groups.map(({ hasPicture, corners }) => [hasPicture, corners])).toEqual([
      [true, [0, 1, 2]],
      [false, [3, 4, 5]],
    ]);
    const uvs = new Float32Array(12);
    writePlaces(uvs, places, material(0), groups[0]!);
    expect([...uvs]).toEqual([0.5, 2, 4.5, 8, 8.5, 14, 0, 0, 0, 0, 0, 0]);
  });
});
