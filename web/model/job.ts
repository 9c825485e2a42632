/**
 * What comes out of a job, and what another may start from, as plain data. Lengths are millimetres unless a
 * name says otherwise; indices count from 0; typed arrays are copies that the receiver owns.
 */
import type { PartName } from './job-options.js';
import type { EngineLooks, Looks, OriginalSurface } from './looks.js';
import type { Message } from './message.js';
import type { Stage } from './stages.js';

/** Something that was mended or noticed in the file, and how many vertices, edges or faces it concerns. */
export interface Repair extends Message {
  count: number;
}

/** Something to know about the result. */
export type Notice = Message;

/** The repaired model at its finished size; y is up. */
export interface Model {
  /** 3 per vertex. */
  vertices: Float64Array;
  /** 3 per face, counter-clockwise from outside. */
  faces: Int32Array;
  components: number;
}

/**
 * A path of all fold angles from flat to folded, linear between its keys, on which no faces run
 * into each other: proved for all of it.
 */
export interface Motion {
  /** The face of the piece that stays where it is. */
  root: number;
  /** Of the keys, ascending from 0 (flat) to 1 (folded). */
  times: Float64Array;
  /** Per key and edge of the piece, in degrees as `foldAngles`; NaN for B. */
  angles: Float64Array;
}

/** Flaps of a piece; like its vertices they are seen from the printed side. */
export interface Flaps {
  /** Per flap: the first edge of the piece that it is attached to. */
  edges: Int32Array;
  /** 2 per flap: the vertices where those edges begin and end; they lie on a straight line. */
  bases: Int32Array;
  /** 8 per flap: x and y of foot, top, top and foot, in the direction of the edge. */
  corners: Float64Array;
  /** Per flap: fold angle of its base in degrees, valley positive, mountain negative. */
  angles: Float64Array;
}

/** A text on a piece: its name, or the id of a cut edge. */
export interface PieceLabel {
  text: string;
  /** The middle of its box, as the vertices are. */
  x: number;
  y: number;
  /** Of its baseline, counter-clockwise from the right, in (-90, 90] degrees. */
  angle: number;
  /** Of the font. */
  size: number;
  /** Where it stands apart from what it names: x and y of both ends of a line that leads there. */
  leader?: Float64Array;
  /** Whether it stands beside the piece, on what is cut off. */
  isBeside?: boolean;
}

/** A loose strip of paper, to be glued behind both sides of a cut edge that has no flap. */
export interface Strip {
  /** Of the seam that it joins, as `JobResult.ids` names them. */
  id: string;
  modelEdge: number;
  sheet: number;
  /** x and y of the corners, counter-clockwise, from the sheet's lower left. */
  outline: Float64Array;
  /** x and y of both ends of its fold. */
  fold: Float64Array;
  /** Degrees: valley positive, mountain negative. */
  foldAngle: number;
  label: PieceLabel;
}

/** What is glued to what: cut edges in a straight line between two panels, or a joint. */
export interface NamedSeam {
  /** Ascending; of a joint the one that is glued. */
  modelEdges: Int32Array;
  /** Indices of the two pieces, or twice the same. */
  pieces: [number, number];
  /** What is printed at its two sides: `C3` on A and `A3` on C, or `3` twice on one piece. */
  texts: [string, string];
  /** The same for lists: `A-C:3`, `A:3`. */
  name: string;
}

/** What came of the flaps of cut edges between two faces that are longer than 4 mm. */
export interface FlapCounts {
  wanted: number;
  /** By the better side: of full height, and lower ones. */
  full: number;
  shrunk: number;
  /** Why others are missing: wedge too narrow, neighbour too thin, blocked, edge too short. */
  missing: { narrow: number; thin: number; blocked: number; short: number };
  /** Length of the edges that want flaps, and of those without. */
  wanted_mm: number;
  missing_mm: number;
  /** Flaps on open borders. */
  borders: number;
  /** Edges served by loose strips, and edges left for tape. */
  strips: number;
  taped: number;
}

/** One net on paper. */
export interface Piece {
  id: number;
  /** On paper: a letter, or what a person called its part. */
  name: string;
  part: number;
  /**
   * Why the piece exists: it is a whole part, or a share of a part without a net, or a motion, or
   * of one too large for the sheet, or a person cut it or joined it.
   */
  cause: 'part' | 'no-net' | 'no-motion' | 'sheet' | 'edit';
  /** Overlapping face pairs found by the independent check; 0 in every finished net. */
  overlaps: number;
  width: number;
  height: number;
  /** 2 per vertex, y up; the bounding box, flaps included, starts at (0, 0). */
  vertices: Float64Array;
  /** 3 per face, counter-clockwise from the printed side, corner by corner those of its source. */
  faces: Int32Array;
  /** Per face: its index in the model. */
  sources: Int32Array;
  /** 2 per edge: indices of vertices. */
  edges: Int32Array;
  /** One letter per edge: B cut or border, M mountain, V valley, F flat. */
  assignments: string;
  /** Per edge, degrees: valley positive, mountain negative; NaN for B. */
  foldAngles: Float64Array;
  /** Per edge: its edge of the model; the two sides of a cut share it. */
  modelEdges: Int32Array;
  /** How it folds up: all folds evenly together, some ahead of others, or in no way that was found. */
  foldable: 'line' | 'waypoints' | 'no' | 'unchecked';
  /** Present if it folds up. */
  motion?: Motion;
  /** Closed boundary walks as vertex indices, the outer one first and counter-clockwise; slits are
   * walked there and back. */
  outlines: Int32Array[];
  /** Lengths in mm, ascending, of folds that are too short for what hangs at them on both sides. */
  necks: Float64Array;
  flaps: Flaps;
  /** No text touches a line, or another text. */
  labels: PieceLabel[];
  /** Short strokes across edges to be joined by tape; x and y of both ends of each. */
  tapeMarks: Float64Array;
  /** Lines in its flat panels where other pieces stand on it; x and y of both ends of each. */
  jointLines: Float64Array;
  /** Place: the sheet, and where on it (0, 0) of the piece lies, from the sheet's lower left. */
  sheet: number;
  x: number;
  y: number;
  /** How it was turned to lie there from how its net came; degrees, counter-clockwise. */
  angle: number;
}

/** A net from which another job can start. Faces and edges are those of the model. */
export interface SavedNet {
  part: number;
  cause: Piece['cause'];
  faces: Int32Array;
  /** The first edge of every line along which it folds. */
  folds: Int32Array;
  foldable: Piece['foldable'];
  /** Of the keys of its motion; empty without one. */
  times: Float64Array;
  /** Per key, the share of its angle that each fold has then. */
  shares: Float64Array[];
  /** Takes its flat copy, as the engine makes it, to its place on a sheet: mm, degrees. */
  place?: { sheet: number; x: number; y: number; angle: number };
}

/**
 * Makes some parts that touch into another number of parts: one into several splits it, two into one
 * merges them, one into one searches it again. Parts are those of the result before.
 */
export interface PartEdit {
  parts: number[];
  into: number;
}

/** Two vertices of the repaired model, in either order. */
export type EdgeName = readonly [number, number];

/** A change of nets that does not go by whole parts. */
export type NetEdit =
  | { kind: 'cut'; edge: EdgeName }
  /** In one net the loop is opened at `open`, or where that leaves least to glue. */
  | { kind: 'join'; edge: EdgeName; open?: EdgeName; search?: boolean }
  | { kind: 'assign'; faces: readonly number[]; part: number }
  /** Makes the edge what it says; that it stays so is up to `locks` of later jobs. */
  | { kind: 'lock'; edge: EdgeName; as: 'fold' | 'cut' | 'free' };

/** An earlier result and what to change in it. No part is named by two edits of parts. */
export interface JobStart {
  labels: Int32Array;
  nets: SavedNet[];
  /** Made first, one after the other. */
  netEdits: readonly NetEdit[];
  partEdits: readonly PartEdit[];
  /**
   * Given if sheets and size are still those that were asked for then: what is left alone keeps its
   * size and, if that takes no more sheets, its place.
   */
  paper: { scale: number; sheets: number; sheetWidth: number } | null;
}

export interface Sheet {
  width: number;
  height: number;
}

export interface JobResult {
  /** Name of the file that the model was read from. */
  file: string;
  model: Model;
  /** How far simplifying moved the surface, in mm: at most, of the vertices before and after; 0 if it did not. */
  deviation: number;
  repairs: Repair[];
  /** Per face of the file as read: its part, -1 if dropped. */
  segmentation: Int32Array;
  /** Per face of the repaired model: its part. */
  labels: Int32Array;
  parts: number;
  /** Those that were chosen and still have their part, by the numbers of these parts. */
  names: PartName[];
  /** In the order of gluing. */
  pieces: Piece[];
  /** Of the pieces, and after them of bodies that are too small to be printed. */
  nets: SavedNet[];
  sheets: Sheet[];
  /** By id. */
  strips: Strip[];
  /** Area of the faces over the area of the sheets. */
  efficiency: number;
  /** Millimetres per unit of the model. */
  scale: number;
  /** Absent where the files say nothing of it, or nothing but white. */
  looks?: Looks;
  /** The surface as it was before it was simplified, where its light is to be printed and the looks do not have it. */
  original?: OriginalSurface;
  seams: NamedSeam[];
  flaps: FlapCounts;
  /**
   * Seams with their id at both sides, and those where it is unreadable at one at least: `A-C:3` is
   * the third seam of A and C, `A:3` the third within A.
   */
  ids: { printed: number; skipped: string[] };
  search: { generations: number; moves: number };
  notices: Notice[];
  /** Hash of the engine's canonical dump (trees, labels, angles, coordinates). */
  hash: string;
}

/** A result as the engine gives it, which does not know the files beside the model. */
export type EngineResult = Omit<JobResult, 'looks' | 'original'> & { looks?: EngineLooks };

/** The foldability matrix as a picture: rows and columns averaged down to at most 256. */
export interface MatrixPicture {
  size: number;
  /** Row-major, 0 (never) to 255 (always unfold together). */
  values: Uint8Array;
  /** Once clustered: rows are sorted by part, and these are the first rows of the parts. */
  blocks?: Int32Array;
}

/** A net while it is being searched. */
export interface NetPicture {
  /** 2 per corner, 3 corners per face; units of the model, y up. */
  corners: Float32Array;
  /** Per face: its index in the model. */
  sources: Int32Array;
  /** Per face: 1 if it overlaps another one. */
  overlapping: Uint8Array;
}

/** What a job tells while it runs; `progress` is in [0, 1] over the whole job and never falls. */
export type JobEvent<Result = JobResult> =
  | { type: 'stage'; stage: Stage; progress: number }
  /** The repaired model in its own units, once it is read; `file`: name of the one that it was in. */
  | { type: 'model'; file: string; vertices: Float32Array; faces: Int32Array }
  | { type: 'learned'; runs: number; of: number; matrix?: MatrixPicture }
  | { type: 'segmented'; labels: Int32Array }
  | {
      type: 'generation';
      part: number;
      generation: number;
      best: number;
      overlaps: number;
      hyperbolic: number;
      net?: NetPicture;
    }
  | { type: 'net'; part: number; piece: number }
  | ({ type: 'notice' } & Message)
  /** Where drafts are asked for: what a run would come to if it were stopped now, which is whole. */
  | { type: 'draft'; result: Result }
  | { type: 'done'; result: Result }
  /** Ended on demand; `best` holds the nets found so far, if any: other faces are in no piece. */
  | { type: 'cancelled'; best?: Result }
  /** `faces`: of the repaired model, that it is about. */
  | ({ type: 'error'; faces?: Int32Array } & Message);

/** What the engine tells. */
export type EngineEvent = JobEvent<EngineResult>;
