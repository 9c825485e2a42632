/** How a net folds up: per key and edge an angle in degrees, null at cuts. */
export interface FoldMotion {
  root: number;
  t: number[];
  angles: (number | null)[][];
  certified: boolean;
}

/** The parts of a FOLD file that the checks read; nothing here comes from the exporter. */
export interface NetFrame {
  frame_classes: string[];
  frame_unit: string;
  vertices_coords: number[][];
  edges_vertices: number[][];
  edges_assignment: string[];
  edges_foldAngle: (number | null)[];
  faces_vertices: number[][];
  'faces_foldwright:source': number[];
  'foldwright:piece': number;
  'foldwright:part': number;
  'foldwright:motion'?: FoldMotion;
}

export interface FoldFile {
  file_spec: number;
  file_creator: string;
  file_classes: string[];
  frame_classes: string[];
  frame_unit: string;
  vertices_coords: number[][];
  faces_vertices: number[][];
  file_frames: NetFrame[];
}

export function parseFold(text: string): FoldFile {
  return JSON.parse(text) as FoldFile;
}
