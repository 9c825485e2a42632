/** What goes into a job, as plain data. Lengths are millimetres unless a name says otherwise. */
import type { RepairStep } from './repair-steps.js';

export type Heuristic = 'steepest' | 'flat' | 'hybrid' | 'random';
export type Segmenter = 'merge' | 'spectral';
export type Solver = 'tree' | 'genetic';
export type FoldingMode = 'require' | 'prefer' | 'off';
export type Orientation = 'auto' | 'portrait' | 'landscape';
/** What decides the finished size; 'fit': the largest piece just fits the sheet. */
export type Sizing = 'fit' | 'height' | 'width' | 'depth' | 'scale' | 'sheets';
/** The axis of the file that points up; the model is turned so that it becomes y. */
export type Up = 'guess' | 'x' | 'y' | 'z';
export type FlapSide = 'none' | 'one' | 'alternate' | 'both';
/** Where the ids of cut edges go: on the faces, on flaps (beside edges without one), or both. */
export type IdPlace = 'none' | 'inside' | 'flap' | 'both' | 'outside';
export type FlapStyle = 'edge' | 'run' | 'zigzag';
/** Loose strips for edges that get no flap: none, where sheets have room, or on further sheets, too. */
export type GlueStrips = 'none' | 'free' | 'all';
export type Unit = 'guess' | 'mm' | 'cm' | 'm' | 'in';

/** A choice for one edge, which other settings for flaps then do not touch. */
export interface FlapChoice {
  /** Vertices of the repaired model. */
  from: number;
  to: number;
  /**
   * Which of the faces beside the edge bear a flap, seen from `from` to `to` and from outside; 'usual':
   * as with all others.
   */
  flaps: 'none' | 'left' | 'right' | 'both' | 'usual';
  /** Of a full flap there, mm; that of all others unless given. */
  height?: number;
}

/** An edge of the repaired model, by its vertices, that is always a fold, or never one. */
export interface EdgeLock {
  from: number;
  to: number;
  as: 'fold' | 'cut';
}

/** A person's name for a part. */
export interface PartName {
  part: number;
  /** Up to 16 characters, no colon, and not a number. */
  name: string;
}

/** A piece that stays where a person put it, as long as there is one with this part and face. */
export interface PinnedPiece {
  part: number;
  /** The first of the piece's `sources`. */
  face: number;
  /** Place and turn as those of a `Piece`. */
  sheet: number;
  x: number;
  y: number;
  angle: number;
}

export interface JobOptions {
  /** Number of parts; 0 estimates it. */
  parts: number;
  /** Heuristic of the learning runs. */
  heuristic: Heuristic;
  segment: Segmenter;
  solver: Solver;
  /** What becomes of a net without a folding motion: split, kept and reported, or not looked at. */
  folding: FoldingMode;
  /** How far apart faces stay while folding, in mean edge lengths. */
  clearance: number;
  /** Learning runs. */
  runs: number;
  /** Learn on a simplified proxy above this many faces; 0: never. */
  proxy: number;
  seed: number;
  /** Simplify to this many triangles first; 0: keep all. */
  faces: number;
  /** 'guess': from the file's format. */
  up: Up;
  /** Steps of the repair that are not done; what they would do is told. */
  repairOff: readonly RepairStep[];
  /** Fill holes up to so many percent of the model's longest side across; 0: none. */
  fillHoles: number;
  /** Leave out bodies that lie inside others. */
  dropInner: boolean;
  /** Make one surface of closed bodies that run through each other. */
  unite: boolean;
  sizing: Sizing;
  /**
   * Height (along y), width (along x) or depth (along z) in mm, once y is up; a factor, or a number of
   * sheets; not read by 'fit'.
   */
  size: number;
  /** Unit of the model, for the factor. */
  unit: Unit;
  /** On which side of a cut edge flaps go; 'one': the one with more room. */
  flapSide: FlapSide;
  flapHeight: number;
  /** Of a flap's sides at its base, at most; degrees. */
  flapAngle: number;
  /**
   * What flaps along a gently bending run of seams look like: each as any other, as a strip with a
   * notch at each corner, or as teeth.
   */
  flapStyle: FlapStyle;
  /** Whether open borders of the model get flaps as well. */
  flapBorders: boolean;
  /** Of several choices for one edge the last counts. */
  flapEdges: FlapChoice[];
  locks: EdgeLock[];
  glueStrips: GlueStrips;
  ids: IdPlace;
  /** Parts without a name have pieces with letters. In a job with a start: parts of the result before. */
  names: PartName[];
  /** With automatic orientation, the first one on which these fit is taken. */
  pins: PinnedPiece[];
  /** Make nets better to craft once they are found: room for flaps, a small outline, strong necks. */
  compaction: boolean;
  /** Paper, portrait: width <= height. */
  paperWidth: number;
  paperHeight: number;
  orientation: Orientation;
  margin: number;
  /** Bodies of the model that are shorter than this along each axis, in mm, are not printed. */
  minPiece: number;
}
