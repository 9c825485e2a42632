/** Edges, faces and parts of a model that are found again in a corrected one. */
import { describe, expect, it } from 'vitest';
import { ModelMatch, type MatchedModel } from '../../web/model/model-match.js';
import type { EdgeName } from '../../web/model/job.js';
import { wavyRing } from './model-text.js';

type Mesh = { vertices: number[][]; faces: number[][] };

const ring = wavyRing(10);

function sized({ vertices, faces }: Mesh, scale = 1): MatchedModel {
  const points = Float64Array.from(vertices.flat(), (value) => value * scale);
  return { model: { vertices: points, faces: Int32Array.from(faces.flat()) }, scale };
}

/** The same surface with its vertices in another order, and the new number of each. */
function reordered({ vertices, faces }: Mesh): {
  mesh: Mesh;
  numberOf: (vertex: number) => number;
} {
  const last = vertices.length - 1;
  const numberOf = (vertex: number): number => last - vertex;
  const mesh = {
    vertices: [...vertices].reverse(),
    faces: faces.map((face) => face.map(numberOf)),
  };
  return { mesh, numberOf };
}

/** The mesh without the faces around a vertex. */
function without({ vertices, faces }: Mesh, vertex: number): Mesh {
  return { vertices, faces: faces.filter((face) => !face.includes(vertex)) };
}

const moved = ({ vertices, faces }: Mesh, to: (point: number[]) => number[]): Mesh => ({
  vertices: vertices.map(to),
  faces,
});

const edges = ring.faces.map(([v, w]): EdgeName => [v!, w!]);

describe('ModelMatch', () => {
  it.each([
    ['the same order', ring, (vertex: number) => vertex, 1],
    ['another order', reordered(ring).mesh, reordered(ring).numberOf, 1],
    ['another size on paper', ring, (vertex: number) => vertex, 0.3],
  ])('finds all edges and faces of the same model in %s', (_, mesh, numberOf, scale) => {
    const match = new ModelMatch(sized(ring), sized(mesh, scale));
    for (const [v, w] of edges) expect(match.edge([v, w])).toEqual([numberOf(v), numberOf(w)]);
    expect(match.edge([edges[0]![1], edges[0]![0]])).toEqual(
      [edges[0]![1], edges[0]![0]].map(numberOf),
    );
    ring.faces.forEach((_, face) => expect(match.faces([face])).toEqual([face]));
  });

  it('finds it in a file in other units, and at another place', () => {
    const inches = moved(ring, (point) => point.map((value) => 7 + value / 25.4));
    const match = new ModelMatch(sized(ring), sized(inches, 3));
    for (const edge of edges) expect(match.edge(edge)).toEqual(edge);
  });

  it('finds what stayed of a model that reaches farther at one end', () => {
    // The vertex that is farthest along x goes out by a quarter of the model.
    const far = ring.vertices.reduce(
      (best, [x], i) => (x! > ring.vertices[best]![0]! ? i : best),
      0,
    );
    const longer = moved(ring, (point) => point);
    longer.vertices[far] = ring.vertices[far]!.map((value, axis) => value + (axis === 0 ? 25 : 0));
    const match = new ModelMatch(sized(ring, 2), sized(longer, 1.7));
    for (const [v, w] of edges) {
      const isThere = v !== far && w !== far;
      expect(match.edge([v, w])).toEqual(isThere ? [v, w] : null);
    }
  });

  it('takes vertices for the same within a hundredth of the diagonal, and no farther', () => {
    const size = [0, 1, 2].map((axis) => {
      const values = ring.vertices.map((point) => point[axis]!);
      return Math.max(...values) - Math.min(...values);
    });
    const diagonal = Math.hypot(...size);
    const at = ring.vertices.findIndex(([x, y, z]) => x! > 20 && x! < 40 && y! < 30 && z! < 5);
    const [v, w] = edges.find((edge) => edge.includes(at))!;
    const nudged = (way: number): MatchedModel => {
      const mesh = moved(ring, (point) => point);
      mesh.vertices[at] = ring.vertices[at]!.map((value, axis) => value + (axis === 0 ? -way : 0));
      return sized(mesh);
    };
    expect(new ModelMatch(sized(ring), nudged(0.009 * diagonal)).edge([v, w])).toEqual([v, w]);
    expect(new ModelMatch(sized(ring), nudged(0.02 * diagonal)).edge([v, w])).toBe(null);
  });

  it('knows what is gone: edges, faces, and vertices that there never were', () => {
    const match = new ModelMatch(sized(ring), sized(without(ring, 14)));
    const gone = ring.faces.findIndex((face) => face.includes(14));
    const [v, w] = ring.faces[gone]!.filter((vertex) => vertex !== 14);
    expect(match.edge([14, v!])).toBe(null);
    // The rim of the hole is still there.
    expect(match.edge([v!, w!])).toEqual([v, w]);
    expect(match.faces([gone])).toBe(null);
    expect(match.faces([0, gone])).toBe(null);
    expect(match.edge([0, 999])).toBe(null);
  });

  it('finds the finer faces that lie on one', () => {
    // Face 3 becomes three around its middle.
    const [a, b, c] = ring.faces[3]!;
    const middle = [0, 1, 2].map((axis) => {
      return [a!, b!, c!].reduce((sum, vertex) => sum + ring.vertices[vertex]![axis]! / 3, 0);
    });
    const hub = ring.vertices.length;
    const finer = {
      vertices: [...ring.vertices, middle],
      faces: [
        ...ring.faces.slice(0, 3),
        [a!, b!, hub],
        ...ring.faces.slice(4),
        [b!, c!, hub],
        [c!, a!, hub],
      ],
    };
    const match = new ModelMatch(sized(ring), sized(finer));
    const last = ring.faces.length;
    expect(match.faces([3])).toEqual([3, last, last + 1]);
    expect(match.faces([4])).toEqual([4]);
  });

  it('finds groups of which half of the area is shared, both ways', () => {
    const match = new ModelMatch(sized(ring), sized(ring));
    const count = ring.faces.length;
    const halves = Int32Array.from({ length: count }, (_, face) => (face < count / 2 ? 0 : 1));
    const named = Int32Array.from(halves, (half) => (half === 0 ? 5 : 2));
    expect(match.group(0, halves, named)).toBe(5);
    expect(match.group(1, halves, named)).toBe(2);
    // All in one group: each half is within it, but makes hardly half of it.
    const whole = new Int32Array(count);
    const third = Int32Array.from({ length: count }, (_, face) => (face < count / 3 ? 0 : 1));
    expect(match.group(0, third, whole)).toBe(null);
    const tenths = Int32Array.from({ length: count }, (_, face) => face % 10);
    expect(match.group(0, halves, tenths)).toBe(null);
    expect(match.group(7, halves, named)).toBe(null);
  });
});
