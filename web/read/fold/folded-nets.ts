/** The FOLD files that Foldwright writes: the folded model, and every piece with its motion. */
import type { Model, Motion, Piece } from '../../model/job.js';
import type { ModelFile } from '../../model/model-files.js';
import { foldFrames, type FoldFrame } from './fold-frames.js';
import { foldedForm } from './folded-form.js';

/** A folded model with its nets, as a file holds them. */
export interface FoldedNets {
  model: Model;
  /** Every face of the model is in at most one of them. */
  pieces: readonly Piece[];
}

/** Per face of the model: its part; -1 if it is in no piece. */
export function labelsOf({ model, pieces }: FoldedNets): Int32Array {
  const labels = new Int32Array(model.faces.length / 3).fill(-1);
  for (const { part, sources } of pieces) for (const face of sources) labels[face] = part;
  return labels;
}

/** Whether all of the model is in pieces, so that it can fold. */
export function canFold(nets: FoldedNets): boolean {
  return nets.pieces.length > 0 && !labelsOf(nets).includes(-1);
}

/** More parts than any model is divided into. */
const mostParts = 4_000_000;

function modelOf(frame: FoldFrame): Model {
  const vertices = frame.numbers('vertices_coords', 3);
  const faces = frame.indexRows('faces_vertices', 3, vertices.length / 3);
  return { vertices, faces, components: 1 };
}

/** In degrees, a row after the other; of cut edges there is none. */
function motionOf(frame: FoldFrame, faces: number, edges: number): Motion | undefined {
  const key = 'foldwright:motion';
  if (!frame.has(key)) return undefined;
  const motion = frame.object(key);
  const times = motion.values('t');
  const root = motion.wholeNumber('root', faces);
  const angles = motion.numberRowsOrNull('angles', edges);
  const isRising = times.every((time, i) => i === 0 || time > times[i - 1]!);
  const isWhole = times[0] === 0 && times.at(-1) === 1;
  if (times.length < 2 || !isRising || !isWhole) throw frame.fault({ what: 'times', key });
  motion.checkLength('angles', times.length);
  return { root, times, angles };
}

/** Per edge, a number of its edge of the model: both sides of a cut have the same. */
function modelEdgesOf(
  { faces, sources, edges }: Shape,
  { faces: corners, vertices }: Model,
): Int32Array {
  const modelVertex = new Map<number, number>();
  faces.forEach((vertex, at) => {
    modelVertex.set(vertex, corners[3 * sources[Math.floor(at / 3)]! + (at % 3)]!);
  });
  const count = vertices.length / 3;
  return Int32Array.from({ length: edges.length / 2 }, (_, edge) => {
    const [a, b] = [0, 1].map((end) => modelVertex.get(edges[2 * edge + end]!) ?? 0);
    return Math.min(a!, b!) * count + Math.max(a!, b!);
  });
}

type Shape = Pick<Piece, 'vertices' | 'faces' | 'sources' | 'edges'>;

function shapeOf(frame: FoldFrame, model: Model): Shape {
  const vertices = frame.numbers('vertices_coords', 2);
  const faces = frame.indexRows('faces_vertices', 3, vertices.length / 2);
  const sources = frame.indices('faces_foldwright:source', model.faces.length / 3);
  const edges = frame.indexRows('edges_vertices', 2, vertices.length / 2);
  frame.checkLength('faces_foldwright:source', Math.max(1, faces.length / 3));
  return { vertices, faces, sources, edges };
}

/** A letter for each edge: border, mountain, valley or flat. */
function assignmentsOf(frame: FoldFrame, edges: number): string {
  const key = 'edges_assignment';
  frame.checkLength(key, edges);
  const letters = frame.list(key);
  const strange = letters.findIndex((letter) => !/^[BMVF]$/.test(String(letter)));
  if (strange !== -1) throw frame.fault({ what: 'letter', key, entry: strange });
  return letters.join('');
}

function pieceOf(frame: FoldFrame, id: number, model: Model): Piece {
  const shape = shapeOf(frame, model);
  const { edges, faces, vertices } = shape;
  const assignments = assignmentsOf(frame, edges.length / 2);
  frame.checkLength('edges_foldAngle', assignments.length);
  const motion = motionOf(frame, faces.length / 3, assignments.length);
  const xs = vertices.filter((_, at) => at % 2 === 0);
  const ys = vertices.filter((_, at) => at % 2 === 1);
  return {
    ...shape,
    id,
    name: frame.text('frame_title')?.replace(/^Piece /, '') ?? String(id + 1),
    part: frame.wholeNumber('foldwright:part', mostParts),
    cause: 'part',
    overlaps: 0,
    width: extent(xs),
    height: extent(ys),
    assignments,
    foldAngles: frame.numbersOrNull('edges_foldAngle'),
    modelEdges: modelEdgesOf(shape, model),
    foldable: motion ? 'waypoints' : 'unchecked',
    ...(motion && { motion }),
    // What is printed besides is not in the file.
    outlines: [],
    necks: new Float64Array(),
    flaps: {
      edges: new Int32Array(),
      bases: new Int32Array(),
      corners: new Float64Array(),
      angles: new Float64Array(),
    },
    labels: [],
    tapeMarks: new Float64Array(),
    jointLines: new Float64Array(),
    sheet: 0,
    x: 0,
    y: 0,
    angle: 0,
  };
}

function extent(values: Float64Array): number {
  return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
}

/** Throws if a face of the model is in two places. */
function checkSources(frames: readonly FoldFrame[], pieces: readonly Piece[]): void {
  const seen = new Set<number>();
  pieces.forEach(({ sources }, i) => {
    for (const [entry, face] of sources.entries()) {
      const key = 'faces_foldwright:source';
      if (seen.has(face)) throw frames[i]!.fault({ what: 'twice', key, entry, index: face });
      seen.add(face);
    }
  });
}

/** Frames with the nets of pieces, which only Foldwright writes. */
export function netFrames(frames: readonly FoldFrame[]): FoldFrame[] {
  return frames.filter((frame) => frame.isOf('creasePattern') && frame.has('foldwright:piece'));
}

/**
 * The model and the nets in a FOLD file of Foldwright; null for one without nets.
 *
 * @throws Unreadable for a file that is damaged, with the place
 */
export function readFoldedNets(file: ModelFile): FoldedNets | null {
  const frames = foldFrames(file);
  const nets = netFrames(frames);
  if (nets.length === 0) return null;
  const model = modelOf(foldedForm(file.name, frames));
  const pieces = nets.map((frame, id) => pieceOf(frame, id, model));
  checkSources(nets, pieces);
  return { model, pieces };
}
