/** The model and a pencil as flat drawings in mm. */
import { describe, expect, it } from 'vitest';
import { pencilPath, silhouetteOf } from '../../web/view/silhouette.js';

describe('silhouetteOf', () => {
  it('stands on the table at its size, all triangles turned the same way round', () => {
    // Two triangles of a square from (10, 5) to (12, 8), one of them seen from behind, and one from the side.
    const vertices = Float32Array.of(10, 5, 0, 12, 5, 0, 12, 8, 0, 10, 8, 0, 10, 5, 9);
    const faces = Int32Array.of(0, 1, 2, 0, 3, 2, 0, 3, 4);
    const { path, width, height } = silhouetteOf(vertices, faces, 10);
    expect([width, height]).toEqual([20, 30]);
    const drawn = path
      .match(/M[^z]+z/g)!
      .map((triangle) => triangle.match(/-?[\d.]+/g)!.map(Number));
    expect(drawn).toHaveLength(3);
    const areas = drawn.map(
      ([ax, ay, bx, by, cx, cy]) => (bx! - ax!) * (cy! - ay!) - (cx! - ax!) * (by! - ay!),
    );
    expect(areas.map((area) => Math.round(area))).toEqual([600, 600, 0]);
  });
});

describe('pencilPath', () => {
  it('is as long as a new pencil', () => {
    expect(pencilPath()).toContain('L3.75 -175');
  });
});
