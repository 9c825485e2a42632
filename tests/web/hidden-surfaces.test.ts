import { describe, expect, it } from 'vitest';
import { areaOf } from '../../web/export/polygon.js';
import { Scene, type VisibleArea } from '../../web/export/hidden-surfaces.js';
import type { Point } from '../../web/export/point.js';
import { viewFrom, viewNames, type View } from '../../web/export/view-direction.js';
import { bentSheet, cube } from './fixtures.js';

interface Mesh {
  vertices: number[][];
  faces: number[][];
}

const modelOf = ({ vertices, faces }: Mesh) => ({
  vertices: Float64Array.from(vertices.flat()),
  faces: Int32Array.from(faces.flat()),
});

function sceneOf(mesh: Mesh, view: View): Scene {
  return new Scene(modelOf(mesh), view, [...mesh.faces.keys()]);
}

/** Several meshes as one. */
function together(...meshes: Mesh[]): Mesh {
  const all: Mesh = { vertices: [], faces: [] };
  for (const { vertices, faces } of meshes) {
    const first = all.vertices.length;
    all.vertices.push(...vertices);
    all.faces.push(...faces.map((face) => face.map((vertex) => vertex + first)));
  }
  return all;
}

const moved = ({ vertices, faces }: Mesh, by: number[], factor = 1): Mesh => ({
  vertices: vertices.map((at) => at.map((value, k) => factor * value + by[k]!)),
  faces,
});

/** A ring around the y axis with a square section: it hides parts of itself. */
function ring(sides: number): Mesh {
  const section = [
    [20, 0],
    [30, 0],
    [30, 10],
    [20, 10],
  ];
  const vertices = Array.from({ length: sides }, (_, i) => {
    const turn = (2 * Math.PI * i) / sides;
    return section.map(([r, y]) => [r! * Math.cos(turn), y!, r! * Math.sin(turn)]);
  }).flat();
  const faces: number[][] = [];
  for (let i = 0; i < sides; ++i) {
    for (let k = 0; k < 4; ++k) {
      const [a, b] = [4 * i + k, 4 * i + ((k + 1) % 4)];
      const [c, d] = [(a + 4) % (4 * sides), (b + 4) % (4 * sides)];
      faces.push([a, b, d], [a, d, c]);
    }
  }
  return { vertices, faces };
}

const shapes: [string, Mesh][] = [
  ['a cube', cube],
  ['a ring', ring(12)],
  ['an open sheet', bentSheet],
  ['a cube without a lid', { vertices: cube.vertices, faces: cube.faces.slice(2) }],
  ['two cubes behind each other', together(cube, moved(cube, [25, 15, 90], 0.7))],
  ['two cubes that cross', together(cube, moved(cube, [17, 13, 11]))],
  ['a cube on a cube', together(cube, moved(cube, [10, 10, 40], 0.5))],
];

const dot = (a: readonly number[], b: readonly number[]) =>
  a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;

interface Hit {
  face: number;
  depth: number;
}

/** Casts rays: knows nothing of polygons. */
class Rays {
  private readonly corners: number[][][];

  constructor(mesh: Mesh, { right, up, towards }: View) {
    const seen = mesh.vertices.map((at) => [dot(at, right), dot(at, up), dot(at, towards)]);
    this.corners = mesh.faces.map((face) => face.map((vertex) => seen[vertex]!));
  }

  /** Faces on the ray through a point, the nearest first. */
  through([x, y]: Point): Hit[] {
    const hits: Hit[] = [];
    this.corners.forEach(([a, b, c], face) => {
      const twice = (b![0]! - a![0]!) * (c![1]! - a![1]!) - (b![1]! - a![1]!) * (c![0]! - a![0]!);
      if (Math.abs(twice) < 1e-9) return;
      const p = ((b![0]! - x) * (c![1]! - y) - (b![1]! - y) * (c![0]! - x)) / twice;
      const q = ((c![0]! - x) * (a![1]! - y) - (c![1]! - y) * (a![0]! - x)) / twice;
      if (p < 0 || q < 0 || p + q > 1) return;
      hits.push({ face, depth: p * a![2]! + q * b![2]! + (1 - p - q) * c![2]! });
    });
    return hits.sort((a, b) => b.depth - a.depth);
  }

  /** Points of a grid over all faces, and the area that each stands for. */
  grid(count: number): { points: Point[]; share: number } {
    const all = this.corners.flat();
    const [left, right] = [0, 0].map((_, i) => (i ? Math.max : Math.min)(...all.map(([x]) => x!)));
    const [bottom, top] = [0, 0].map((_, i) =>
      (i ? Math.max : Math.min)(...all.map(([, y]) => y!)),
    );
    const [dx, dy] = [(right! - left!) / count, (top! - bottom!) / count];
    const points = Array.from({ length: count * count }, (_, i): Point => [
      left! + ((i % count) + 0.5) * dx,
      bottom! + (Math.floor(i / count) + 0.5) * dy,
    ]);
    return { points, share: dx * dy };
  }
}

const contains = (walk: Point[], [x, y]: Point, slack: number) =>
  walk.every(([ax, ay], i) => {
    const [bx, by] = walk[(i + 1) % walk.length]!;
    const cross = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    return cross >= -slack * Math.hypot(bx - ax, by - ay);
  });

const sum = (areas: VisibleArea[]) => areas.reduce((all, { walk }) => all + areaOf(walk), 0);

describe('what is seen of a model', () => {
  it.each(viewNames)('is three sides of a cube: %s', (name) => {
    const areas = sceneOf(cube, viewFrom(name)).areas();
    expect(areas).toHaveLength(6);
    expect(new Set(areas.map(({ face }) => Math.floor(face / 2))).size).toBe(3);
    expect(areas.every(({ isBack }) => !isBack)).toBe(true);
  });

  it.each(shapes)('covers its silhouette, without a gap and once: %s', (_, mesh) => {
    for (const name of viewNames) {
      const view = viewFrom(name);
      const rays = new Rays(mesh, view);
      const { points, share } = rays.grid(200);
      const silhouette = share * points.filter((point) => rays.through(point).length > 0).length;
      // Cells at the edge of the silhouette count whole or not at all.
      expect(Math.abs(sum(sceneOf(mesh, view).areas()) / silhouette - 1)).toBeLessThan(0.004);
    }
  });

  it.each(shapes)('is at every point what a ray meets first: %s', (_, mesh) => {
    for (const name of viewNames) {
      const view = viewFrom(name);
      const areas = sceneOf(mesh, view).areas();
      const rays = new Rays(mesh, view);
      for (const point of rays.grid(25).points) {
        const hits = rays.through(point);
        const seen = areas.filter(({ walk }) => contains(walk, point, -1e-6));
        // Between faces a point may be in none; what it is in is in front.
        expect(seen.length).toBeLessThanOrEqual(1);
        for (const { face } of seen) {
          const hit = hits.find((other) => other.face === face)!;
          expect(hits[0]!.depth - hit.depth).toBeLessThan(1e-4);
        }
        if (hits.length === 0) expect(seen).toEqual([]);
        else expect(areas.some(({ walk }) => contains(walk, point, 1e-6))).toBe(true);
      }
    }
  });

  it('is nothing of what lies behind something else', () => {
    const { towards } = viewFrom('front-left');
    const behind = moved(
      cube,
      towards.map((value) => 20 - 200 * value),
      0.4,
    );
    const front = moved(cube, [0, 0, 0], 1.6);
    const areas = sceneOf(together(front, behind), viewFrom('front-left')).areas();
    expect(Math.max(...areas.map(({ face }) => face))).toBeLessThan(cube.faces.length);
  });

  it('is the inner side of paper where there is no outer one in front', () => {
    const open = { vertices: cube.vertices, faces: cube.faces.filter((_, i) => i < 10) };
    const areas = viewNames.flatMap((name) => sceneOf(open, viewFrom(name)).areas());
    expect(areas.some(({ isBack }) => isBack)).toBe(true);
  });

  it('is of faces in one plane the first one alone', () => {
    const sheet: Mesh = { vertices: bentSheet.vertices, faces: [[0, 1, 2]] };
    const view = viewNames.map(viewFrom).find((one) => one.towards[2] > 0)!;
    const areas = sceneOf(together(sheet, sheet), view).areas();
    expect(areas.map(({ face }) => face)).toEqual([0]);
  });
});

describe('what is seen of lines', () => {
  const edges = (mesh: Mesh) => {
    const known = new Map<string, [number, number]>();
    for (const face of mesh.faces) {
      face.forEach((from, i) => {
        const to = face[(i + 1) % 3]!;
        known.set([from, to].sort((a, b) => a - b).join(), [from, to]);
      });
    }
    return [...known.values()];
  };

  it('is nine whole edges of a cube', () => {
    const sides = edges(cube).filter(
      ([a, b]) =>
        cube.vertices[a]!.filter((value, k) => value !== cube.vertices[b]![k]).length === 1,
    );
    expect(sides).toHaveLength(12);
    for (const name of viewNames) {
      const seen = sceneOf(cube, viewFrom(name)).lines(sides);
      expect(seen).toHaveLength(9);
      expect(new Set(seen.map(({ line }) => line)).size).toBe(9);
    }
  });

  it('lies where a ray meets nothing in front of it', () => {
    const mesh = together(cube, moved(cube, [17, 13, 11]), moved(ring(12), [0, 30, 0]));
    const view = viewFrom('front-right');
    const rays = new Rays(mesh, view);
    const lines = edges(mesh);
    const depths = mesh.vertices.map((at) => dot(at, view.towards));
    const places = mesh.vertices.map((at): Point => [dot(at, view.right), dot(at, view.up)]);
    const seen = sceneOf(mesh, view).lines(lines);
    expect(seen.length).toBeGreaterThan(20);
    for (const { line, segment } of seen) {
      const middle: Point = [
        (segment[0][0] + segment[1][0]) / 2,
        (segment[0][1] + segment[1][1]) / 2,
      ];
      const [a, b] = lines[line]!;
      const along = (at: Point) => Math.hypot(at[0] - places[a]![0], at[1] - places[a]![1]);
      const share = along(middle) / along(places[b]!);
      const depth = depths[a]! + share * (depths[b]! - depths[a]!);
      const nearest = rays.through(middle)[0]?.depth ?? -Infinity;
      expect(nearest - depth).toBeLessThan(0.01);
    }
  });
});
