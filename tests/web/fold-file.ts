/** How a net folds up: per key and edge an angle in degrees, null at cuts. */
export interface FoldMotion {
  root: number;
  t: number[];
  angles: (number | null)[][];
  certified: boolean;
}

/** The parts of a crease pattern that the checks read; nothing here comes from the exporter. */
export interface PatternFrame {
  frame_classes: string[];
  frame_unit: string;
  vertices_coords: number[][];
  edges_vertices: number[][];
  edges_assignment: string[];
  edges_foldAngle: (number | null)[];
  faces_vertices: number[][];
  'faces_foldwright:source': number[];
}

/** One piece by itself. */
export interface NetFrame extends PatternFrame {
  'foldwright:piece': number;
  'foldwright:part': number;
  'foldwright:motion'?: FoldMotion;
}

/** The folded form. */
export interface ModelFrame {
  frame_classes: string[];
  frame_unit: string;
  vertices_coords: number[][];
  edges_vertices: number[][];
  faces_vertices: number[][];
}

/** The key frame: all pieces laid out. */
export interface KeyFrame extends PatternFrame {
  file_spec: number;
  file_creator: string;
  file_classes: string[];
}

/** A file, its frames sorted by what they show. */
export interface FoldFile {
  key: KeyFrame;
  model: ModelFrame;
  nets: NetFrame[];
}

type Frame = ModelFrame | NetFrame;

/** @throws if there is not one folded form, followed by one crease pattern a piece */
export function parseFold(text: string): FoldFile {
  const { file_frames, ...key } = JSON.parse(text) as KeyFrame & { file_frames: Frame[] };
  const [model, ...nets] = file_frames;
  if (model?.frame_classes.join() !== 'foldedForm') throw new Error('there is no folded form');
  if (!nets.every((net) => 'foldwright:piece' in net)) throw new Error('a frame is of no piece');
  return { key, model, nets };
}
