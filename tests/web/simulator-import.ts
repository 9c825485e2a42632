/**
 * What Origami Simulator makes of a FOLD file, step by step, from what its importer is known to need.
 * It reads the key frame alone; four lists must be there, and a fifth spares the person a question.
 */
import type { KeyFrame } from './fold-file.js';

/** A fold as the simulation has it: two triangles, the corner of each across it, and its angle. */
export interface Crease {
  edge: number;
  faces: [number, number];
  /** Across the fold, in each of the faces. */
  corners: [number, number];
  /** Degrees. */
  angle: number;
}

export interface SimulatedPattern {
  creases: Crease[];
  /** One sentence for each thing that it would refuse, ask about or get wrong without a word. */
  faults: string[];
}

const needed = ['vertices_coords', 'edges_vertices', 'edges_assignment', 'faces_vertices'] as const;

function listFaults(frame: Partial<KeyFrame>): string[] {
  const faults = needed.filter((key) => !frame[key]).map((key) => `it refuses the file: no ${key}`);
  if (!frame.edges_foldAngle) faults.push('it asks the person whether folds are flat');
  return faults;
}

/** Polygons would be cut into triangles by rules of its own, which need not be the model's. */
function faceFaults({ faces_vertices }: KeyFrame): string[] {
  return faces_vertices.flatMap((face, f) =>
    face.length === 3 ? [] : [`face ${f} has ${face.length} corners`],
  );
}

/** It lays a pattern of two coordinates into its ground plane; a vertex on no beam is lost to it. */
function vertexFaults({ vertices_coords, edges_vertices }: KeyFrame): string[] {
  const held = new Set(edges_vertices.flat());
  return vertices_coords.flatMap((point, vertex) => {
    const faults: string[] = [];
    if (point.length !== 2) faults.push(`vertex ${vertex} has ${point.length} coordinates`);
    if (!held.has(vertex)) faults.push(`vertex ${vertex} is on no edge`);
    return faults;
  });
}

/** The crease along an edge: the first two triangles that have both its ends. */
function creaseAt(
  { edges_vertices, faces_vertices }: KeyFrame,
  edge: number,
): Omit<Crease, 'angle'>[] {
  const [u, v] = edges_vertices[edge]!;
  const beside = faces_vertices.flatMap((face, f) =>
    face.includes(u!) && face.includes(v!)
      ? [{ face: f, corner: face.find((w) => w !== u && w !== v)! }]
      : [],
  );
  const [a, b] = beside;
  if (!a || !b) return [];
  return [{ edge, faces: [a.face, b.face], corners: [a.corner, b.corner] }];
}

function edgeFaults(frame: KeyFrame, creases: Crease[]): string[] {
  const creased = new Map(creases.map((crease) => [crease.edge, crease]));
  return frame.edges_assignment.flatMap((assignment, edge) => {
    const crease = creased.get(edge);
    if (assignment === 'B')
      return frame.edges_foldAngle[edge] === null ? [] : [`cut ${edge} folds`];
    if (!'MVF'.includes(assignment)) return [`edge ${edge} is ${assignment}, which is left loose`];
    if (!crease) return [`fold ${edge} is dropped: it has not two faces, or no angle`];
    const right = { M: crease.angle < 0, V: crease.angle > 0, F: Math.abs(crease.angle) < 1e-3 };
    return right[assignment as 'M' | 'V' | 'F'] ? [] : [`fold ${edge} goes to ${crease.angle}`];
  });
}

/** Reads the text of a file as Origami Simulator does. */
export function simulatedPattern(text: string): SimulatedPattern {
  const parsed = JSON.parse(text) as Partial<KeyFrame>;
  const lists = listFaults(parsed);
  if (lists.length > 0) return { creases: [], faults: lists };
  const frame = parsed as KeyFrame;
  const creases = frame.edges_assignment.flatMap((assignment, edge) => {
    const angle = frame.edges_foldAngle[edge];
    if (!'MVF'.includes(assignment) || typeof angle !== 'number') return [];
    return creaseAt(frame, edge).map((crease) => ({ ...crease, angle }));
  });
  return {
    creases,
    faults: [...faceFaults(frame), ...vertexFaults(frame), ...edgeFaults(frame, creases)],
  };
}
