import type { JobResult, Model, Piece, Sheet } from '../model/job.js';

/** Keys and values in the order in which they are written. */
type Entries = [key: string, value: unknown][];

/** Millimetres between sheets side by side: pieces on sheets without margins do not touch. */
const sheetGap = 10;

/** Rows of `width` numbers each. */
function rows(values: ArrayLike<number>, width: number): number[][] {
  return Array.from({ length: values.length / width }, (_, row) =>
    Array.from({ length: width }, (_, column) => values[width * row + column]!),
  );
}

/** The edges of the model in the order in which its faces first name them. */
function edgesOf({ faces, vertices }: Model): number[][] {
  const seen = new Set<number>();
  const edges: number[][] = [];
  const vertexCount = vertices.length / 3;
  faces.forEach((from, corner) => {
    const to = faces[corner % 3 === 2 ? corner - 2 : corner + 1]!;
    const [low, high] = from < to ? [from, to] : [to, from];
    const key = low * vertexCount + high;
    if (!seen.has(key)) edges.push([low, high]);
    seen.add(key);
  });
  return edges;
}

function modelFrame(model: Model): Entries {
  return [
    ['frame_title', 'Model'],
    ['frame_classes', ['foldedForm']],
    ['frame_attributes', ['3D']],
    ['frame_unit', 'mm'],
    ['vertices_coords', rows(model.vertices, 3)],
    ['edges_vertices', edgesOf(model)],
    ['faces_vertices', rows(model.faces, 3)],
  ];
}

/** Nets in one plane, as the lists of a crease pattern. */
interface Nets {
  vertices: number[][];
  edges: number[][];
  assignments: string[];
  angles: (number | null)[];
  faces: number[][];
  sources: number[];
}

function netOf(piece: Piece): Nets {
  return {
    vertices: rows(piece.vertices, 2),
    edges: rows(piece.edges, 2),
    assignments: [...piece.assignments],
    angles: Array.from(piece.foldAngles),
    faces: rows(piece.faces, 3),
    sources: Array.from(piece.sources),
  };
}

/** Where each sheet begins when all lie side by side from the left to the right. */
function sheetStarts(sheets: readonly Sheet[]): number[] {
  let end = -sheetGap;
  return sheets.map(({ width }) => {
    const start = end + sheetGap;
    end = start + width;
    return start;
  });
}

/** All pieces as they lie on their sheets, and the sheets side by side. */
function layOut({ pieces, sheets }: JobResult): Nets {
  const starts = sheetStarts(sheets);
  const all: Nets = {
    vertices: [],
    edges: [],
    assignments: [],
    angles: [],
    faces: [],
    sources: [],
  };
  for (const piece of pieces) {
    const net = netOf(piece);
    const first = all.vertices.length;
    const left = starts[piece.sheet]! + piece.x;
    const shifted = (lists: number[][]): number[][] =>
      lists.map((list) => list.map((vertex) => first + vertex));
    for (const [x, y] of net.vertices) all.vertices.push([left + x!, piece.y + y!]);
    all.edges.push(...shifted(net.edges));
    all.assignments.push(...net.assignments);
    all.angles.push(...net.angles);
    all.faces.push(...shifted(net.faces));
    all.sources.push(...net.sources);
  }
  return all;
}

function patternFrame(title: string, nets: Nets): Entries {
  return [
    ['frame_title', title],
    ['frame_classes', ['creasePattern']],
    ['frame_attributes', ['2D']],
    ['frame_unit', 'mm'],
    ['vertices_coords', nets.vertices],
    ['edges_vertices', nets.edges],
    ['edges_assignment', nets.assignments],
    // JSON has no NaN: the fold angle of a cut edge becomes null, as the format wants it.
    ['edges_foldAngle', nets.angles],
    ['faces_vertices', nets.faces],
    ['faces_foldwright:source', nets.sources],
  ];
}

function motionEntries(piece: Piece): Entries {
  if (!piece.motion) return [];
  const { root, times, angles } = piece.motion;
  const motion = {
    root,
    t: Array.from(times),
    angles: rows(angles, piece.assignments.length),
    certified: true,
  };
  return [['foldwright:motion', motion]];
}

function pieceFrame(piece: Piece): Entries {
  return [
    ...patternFrame(`Piece ${piece.name}`, netOf(piece)),
    ['foldwright:piece', piece.id],
    ['foldwright:part', piece.part],
    ...motionEntries(piece),
  ];
}

/** One key a line: large files stay easy to compare and to look into. */
function lines(entries: Entries, indent: string): string[] {
  return entries.map(([key, value]) => `${indent}${JSON.stringify(key)}: ${JSON.stringify(value)}`);
}

/**
 * A result as a FOLD 1.2 file: mm, full double precision in shortest form, keys in a fixed order.
 *
 * The key frame is what other programs read, often alone: the crease pattern of all pieces, laid out
 * as on the sheets. The frames after it, which inherit nothing, are the folded model and then every
 * piece by itself, with its motion; `faces_foldwright:source` counts the faces of the folded model.
 */
export function writeFold(result: JobResult): string {
  const head: Entries = [
    ['file_spec', 1.2],
    ['file_creator', 'Foldwright'],
    ['file_classes', ['singleModel']],
    ...patternFrame('All pieces', layOut(result)),
  ];
  const frames = [modelFrame(result.model), ...result.pieces.map(pieceFrame)].map(
    (frame) => `    {\n${lines(frame, '      ').join(',\n')}\n    }`,
  );
  const fileFrames = `  "file_frames": [\n${frames.join(',\n')}\n  ]`;
  return `{\n${[...lines(head, '  '), fileFrames].join(',\n')}\n}\n`;
}
