/**
 * Judges the key frame of a FOLD file, which is all that many programs read: it must be a crease
 * pattern of its own, and show every piece as its own frame has it, only moved.
 */
import type { FoldFile, NetFrame, PatternFrame } from './fold-file.js';
import { edgeFaults, edgeKey, overlapFaults, shapeFaults, sidesOf } from './pattern-check.js';
import { distance, minus } from './vectors.js';

/** Relative to the extent of the frame: what is lost when coordinates are moved along a row of sheets. */
const placeTolerance = 1e-12;

/** For each face the number of its connected piece. */
function piecesOf(pattern: PatternFrame): number[] {
  const root = pattern.faces_vertices.map((_, face) => face);
  const find = (face: number): number => {
    while (root[face] !== face) face = root[face] = root[root[face]!]!;
    return face;
  };
  for (const sides of sidesOf(pattern).values()) {
    const [a, b] = sides.map(({ face }) => find(face));
    if (b !== undefined) root[Math.max(a!, b)] = Math.min(a!, b);
  }
  return root.map(find);
}

/** One piece against what the key frame shows of it: same faces, same place in itself, same folds. */
function pieceFaults(key: PatternFrame, net: NetFrame, tolerance: number): string[] {
  const found: string[] = [];
  const faceOf = new Map(key['faces_foldwright:source'].map((source, face) => [source, face]));
  const vertexOf = new Map<number, number>();
  net.faces_vertices.forEach((corners, face) => {
    const shown = key.faces_vertices[faceOf.get(net['faces_foldwright:source'][face]!) ?? -1];
    corners.forEach((vertex, corner) => vertexOf.set(vertex, shown?.[corner] ?? -1));
  });
  const [first] = vertexOf.keys();
  const at = (frame: PatternFrame, vertex: number) => frame.vertices_coords[vertex] ?? [NaN, NaN];
  for (const [vertex, shown] of vertexOf) {
    const own = minus(at(net, vertex), at(net, first!));
    const there = minus(at(key, shown), at(key, vertexOf.get(first!)!));
    if (!(distance(own, there) <= tolerance)) found.push(`vertex ${vertex} is elsewhere`);
  }
  const edges = new Map(key.edges_vertices.map(([a, b], edge) => [edgeKey(a!, b!), edge]));
  net.edges_vertices.forEach(([a, b], edge) => {
    const shown = edges.get(edgeKey(vertexOf.get(a!)!, vertexOf.get(b!)!)) ?? -1;
    const fits =
      key.edges_assignment[shown] === net.edges_assignment[edge] &&
      key.edges_foldAngle[shown] === net.edges_foldAngle[edge];
    if (!fits) found.push(`edge ${edge} is another one`);
  });
  return found.map((sentence) => `piece ${net['foldwright:piece']}: ${sentence}`);
}

/** One sentence for each thing that is wrong with the key frame; none if it is good. */
export function checkKeyFrame({ key, nets }: FoldFile): string[] {
  const found = shapeFaults(key);
  if (found.length === 0) {
    const faces = nets.reduce((sum, net) => sum + net.faces_vertices.length, 0);
    if (key.faces_vertices.length !== faces) {
      found.push(`has ${key.faces_vertices.length} faces, the pieces have ${faces}`);
    }
    const pieces = new Set(piecesOf(key)).size;
    if (pieces !== nets.length) found.push(`shows ${pieces} pieces instead of ${nets.length}`);
    const tolerance = placeTolerance * Math.max(...key.vertices_coords.flat().map(Math.abs));
    found.push(...edgeFaults(key), ...overlapFaults(key));
    found.push(...nets.flatMap((net) => pieceFaults(key, net, tolerance)));
  }
  return found.map((sentence) => `key frame: ${sentence}`);
}
