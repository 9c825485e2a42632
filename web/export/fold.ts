import type { JobResult, Model, Piece } from '../model/job.js';

/** Keys and values in the order in which they are written. */
type Entries = [key: string, value: unknown][];

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
    ['frame_title', `Piece ${piece.name}`],
    ['frame_classes', ['creasePattern']],
    ['frame_attributes', ['2D']],
    ['frame_unit', 'mm'],
    ['vertices_coords', rows(piece.vertices, 2)],
    ['edges_vertices', rows(piece.edges, 2)],
    ['edges_assignment', [...piece.assignments]],
    // JSON has no NaN: the fold angle of a cut edge becomes null, as the format wants it.
    ['edges_foldAngle', Array.from(piece.foldAngles)],
    ['faces_vertices', rows(piece.faces, 3)],
    ['faces_foldwright:source', Array.from(piece.sources)],
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
 * The folded model and the crease pattern of every piece as a FOLD 1.2 file: mm, full double
 * precision in shortest form, keys in a fixed order. Frames inherit nothing from each other.
 */
export function writeFold(result: JobResult): string {
  const head: Entries = [
    ['file_spec', 1.2],
    ['file_creator', 'Foldwright'],
    ['file_classes', ['singleModel']],
    ...modelFrame(result.model),
  ];
  const frames = result.pieces.map(
    (piece) => `    {\n${lines(pieceFrame(piece), '      ').join(',\n')}\n    }`,
  );
  const fileFrames = `  "file_frames": [\n${frames.join(',\n')}\n  ]`;
  return `{\n${[...lines(head, '  '), fileFrames].join(',\n')}\n}\n`;
}
