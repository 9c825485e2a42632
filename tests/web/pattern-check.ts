/** What must hold of every crease pattern of a FOLD file: one piece, or all of them laid out. */
import type { PatternFrame } from './fold-file.js';
import { overlappingPairs } from './net-overlap.js';
import { distance } from './vectors.js';

/** Relative to the square of the mean edge. */
const areaTolerance = 1e-7;

/** The faces beside an edge, each with the corner at which its walk along it begins. */
export interface Side {
  face: number;
  corner: number;
}

export const edgeKey = (a: number, b: number): string => (a < b ? `${a} ${b}` : `${b} ${a}`);

export function sidesOf(pattern: PatternFrame): Map<string, Side[]> {
  const sides = new Map<string, Side[]>();
  pattern.faces_vertices.forEach((face, f) => {
    face.forEach((from, corner) => {
      const key = edgeKey(from, face[(corner + 1) % face.length]!);
      sides.set(key, [...(sides.get(key) ?? []), { face: f, corner }]);
    });
  });
  return sides;
}

/** The counts and indices that everything else relies on. */
export function shapeFaults(pattern: PatternFrame): string[] {
  const found: string[] = [];
  if (pattern.frame_classes.join() !== 'creasePattern') found.push('is no crease pattern');
  if (pattern.frame_unit !== 'mm') found.push(`its unit is ${pattern.frame_unit}, not mm`);
  const edges = pattern.edges_vertices.length;
  if (pattern.edges_assignment.length !== edges || pattern.edges_foldAngle.length !== edges) {
    found.push('edges, assignments and fold angles differ in number');
  }
  if (pattern['faces_foldwright:source'].length !== pattern.faces_vertices.length) {
    found.push('faces and sources differ in number');
  }
  if (!pattern.vertices_coords.flat().every(Number.isFinite))
    found.push('a coordinate is not finite');
  const known = (vertex: number) => pattern.vertices_coords[vertex]?.length === 2;
  if (![...pattern.faces_vertices.flat(), ...pattern.edges_vertices.flat()].every(known)) {
    found.push('an index of a vertex has no vertex in the plane');
  }
  return found;
}

/** Every side of a face is listed as an edge, once, and cut where no other face joins it. */
export function edgeFaults(pattern: PatternFrame): string[] {
  const found: string[] = [];
  const sides = sidesOf(pattern);
  const listed = new Set<string>();
  pattern.edges_vertices.forEach(([a, b], edge) => {
    const key = edgeKey(a!, b!);
    const faces = sides.get(key)?.length ?? 0;
    const assignment = pattern.edges_assignment[edge]!;
    if (listed.has(key)) found.push(`edge ${edge} is listed twice`);
    listed.add(key);
    if (faces === 0) found.push(`edge ${edge} belongs to no face`);
    if (faces > 2) found.push(`edge ${edge} belongs to ${faces} faces`);
    if (!'BMVF'.includes(assignment)) found.push(`edge ${edge} is assigned ${assignment}`);
    if (faces === 1 && assignment !== 'B') found.push(`edge ${edge} folds but has one face`);
    if (faces === 2 && assignment === 'B') found.push(`edge ${edge} is cut but joins two faces`);
    if (assignment === 'B' && pattern.edges_foldAngle[edge] !== null) {
      found.push(`edge ${edge} is cut but has a fold angle`);
    }
  });
  for (const key of sides.keys()) {
    if (!listed.has(key)) found.push(`the side ${key} of a face is no edge`);
  }
  return found;
}

export function overlapFaults(pattern: PatternFrame): string[] {
  const at = (vertex: number): number[] => pattern.vertices_coords[vertex]!;
  const lengths = pattern.edges_vertices.map(([a, b]) => distance(at(a!), at(b!)));
  const mean = lengths.reduce((sum, value) => sum + value, 0) / lengths.length;
  const polygons = pattern.faces_vertices.map((face) => face.map(at));
  return overlappingPairs(polygons, areaTolerance * mean * mean).map(
    ([a, b]) => `faces ${a} and ${b} overlap`,
  );
}
