/** FOLD files as other programs take them: by the format's own package, and as Origami Simulator does. */
import { convert, filter, geom, type Fold } from 'fold';
import { describe, expect, it } from 'vitest';
import { writeFold } from '../../web/export/fold.js';
import type { JobResult } from '../../web/model/job.js';
import { engineResult } from './engine-result.js';
import { boxAndLidResult, cubeResult, slitResult, tetrahedronResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { simulatedPattern } from './simulator-import.js';
import { isEngineBuilt } from './thread-pool.js';

/** The key frame, as whoever parses the file and looks no further gets it; a new one every time. */
const keyFrame = (result: JobResult): Fold => JSON.parse(writeFold(result)) as Fold;

/** Faces by the corner with the lowest number first: lists of one face may begin anywhere. */
function canonical(faces: number[][]): string[] {
  const rotated = faces.map((face) => {
    const at = face.indexOf(Math.min(...face));
    return [...face.slice(at), ...face.slice(0, at)].join();
  });
  return rotated.sort();
}

const edgeNames = (edges: number[][]): string[] =>
  edges.map((ends) => [...ends].sort((a, b) => a - b).join());

/** What holds of the lists alone, wherever the vertices are. */
function expectConsistent(result: JobResult): void {
  const frame = keyFrame(result);
  const counts = [filter.numVertices(frame), filter.numEdges(frame), filter.numFaces(frame)];
  expect(counts).toEqual([
    frame.vertices_coords.length,
    frame.edges_assignment.length,
    frame.faces_vertices.length,
  ]);
  expect(frame.edges_vertices).toHaveLength(frame.edges_foldAngle.length);
  const cleaned = keyFrame(result);
  filter.removeLoopEdges(cleaned);
  filter.removeDuplicateEdges_vertices(cleaned);
  expect(cleaned.edges_vertices).toEqual(frame.edges_vertices);
  for (const face of frame.faces_vertices) {
    expect(geom.polygonOrientation(face.map((vertex) => frame.vertices_coords[vertex]!))).toBe(1);
  }
  const derived = convert.faces_vertices_to_edges({ faces_vertices: frame.faces_vertices });
  const borders = (fold: Fold): string[] =>
    edgeNames(fold.edges_vertices.filter((_, edge) => fold.edges_assignment[edge] === 'B')).sort();
  expect(edgeNames(derived.edges_vertices).sort()).toEqual(edgeNames(frame.edges_vertices).sort());
  expect(borders(frame)).toEqual(borders(derived));
}

/** Pairs of edges that run through each other; those that only touch at a corner do not. */
function crossings({ edges_vertices, vertices_coords }: Fold): [number, number][] {
  const segments = edges_vertices.map((ends) => ends.map((vertex) => vertices_coords[vertex]!));
  const touch = (a: number[][], b: number[][]): boolean =>
    a.some((p) => b.some((q) => geom.dist(p, q) < geom.EPS));
  return segments.flatMap((a, i) =>
    segments.flatMap((b, j): [number, number][] =>
      j < i && !touch(a, b) && geom.segmentsCross(a, b) ? [[j, i]] : [],
    ),
  );
}

/** What a program finds that has only vertices and edges: no crossings, and the same faces. */
function expectPlanar(result: JobResult): void {
  const frame = keyFrame(result);
  expect(crossings(frame)).toEqual([]);
  const { faces_vertices } = convert.edges_vertices_to_faces_vertices(keyFrame(result));
  expect(canonical(faces_vertices)).toEqual(canonical(frame.faces_vertices));
}

function expectSimulated(result: JobResult): void {
  const pattern = simulatedPattern(writeFold(result));
  const folds = result.pieces.flatMap(({ assignments }) =>
    [...assignments].filter((a) => a !== 'B'),
  );
  expect(pattern.creases).toHaveLength(folds.length);
  expect(pattern.faults).toEqual([]);
}

const results = {
  cube: cubeResult(),
  'box and lid': boxAndLidResult(),
  tetrahedron: tetrahedronResult(),
};

describe('the key frame of a FOLD file', () => {
  it.each(Object.entries(results))('is a planar crease pattern of the %s', (_, result) => {
    expectConsistent(result);
    expectPlanar(result);
  });

  it('keeps the sides of a slit apart', () => {
    expectConsistent(slitResult());
  });

  it.each(Object.entries({ ...results, slit: slitResult() }))(
    'is what Origami Simulator takes: %s',
    (_, result) => expectSimulated(result),
  );
});

describe.skipIf(!isEngineBuilt)('the key frame of a whole run', () => {
  it.each([1, 4])('opens elsewhere with %d parts', async (parts) => {
    const result = await engineResult(objText(wavyRing(8)), { parts, compaction: false });
    expectConsistent(result);
    expectPlanar(result);
    expectSimulated(result);
  });
});
