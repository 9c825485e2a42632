import type { Model, Piece } from '../model/job.js';
import type { Looks } from '../model/looks.js';
import type { ModelFile } from '../model/model-files.js';
import type { Vector } from '../model/vector.js';
import type { MarkKind } from './sheet-marks.js';

/** Why a place is pointed at: a mouse is over it, or it is clicked, alone or to add to what is chosen. */
export type Pointing = 'over' | 'choose' | 'add';

/** A turn by hand around the model. */
export interface Turn {
  /** Radians around the upright axis. */
  around: number;
  /** Radians downwards. */
  down: number;
  /** How many times as far away. */
  away: number;
}

/** A finished model and the pieces that it is folded from. */
export interface Folding {
  model: Model;
  /** Every face of the model is in one of them. */
  pieces: Piece[];
}

/** What a picture of a model is told, in plain data: another thread may be the one that draws. */
export type ModelMessage =
  /**
   * Another model, as blank paper or as glass that shows what lies inside, from the first point of view unless that of
   * the model before stays. 3 numbers per vertex and face.
   */
  | {
      type: 'model';
      vertices: Float32Array | Float64Array;
      faces: Int32Array;
      keepsView?: boolean;
      isGlass?: boolean;
    }
  /** The parts of the faces; -1 is blank paper. Those of another model are ignored. */
  | { type: 'labels'; labels: Int32Array }
  /** Parts that stand out; all others fade, unless there are none. */
  | { type: 'selected'; parts: readonly number[] }
  /**
   * Edges that are lit in place of those before: 2 vertices of the model each, as the face walks them whose side is
   * meant. `from`: a direction from which the model is looked at then, as long as it is whole.
   */
  | { type: 'lights'; edges: Int32Array; from: Vector | null }
  /** Edges that a building step is about, in place of those before, as for `lights`, and why for each of them. */
  | { type: 'step'; edges: Int32Array; kinds: readonly MarkKind[] }
  /** Which face is seen at a place, from -1 to 1 to the right and up? Every question is answered. */
  | { type: 'point'; x: number; y: number; why: Pointing }
  /** Faces that are lit, in place of those before. Those of another model are ignored. */
  | { type: 'lit'; faces: Int32Array }
  /**
   * A hand that paints, where it is as for `point`. It begins with the colour of a part and pulls it over other faces,
   * which is answered at its end; where it begins beside the model, it turns that.
   */
  | ({ type: 'stroke'; phase: 'begin' | 'move' | 'end'; x: number; y: number } & Turn)
  /** Whether hatches tell the parts apart, besides colours. */
  | { type: 'hatched'; hatched: boolean }
  /** What the looks that come have as pictures. */
  | { type: 'pictures'; pictures: readonly ModelFile[] }
  /** How the model that is shown looks by its files; null for the colours of its parts. */
  | { type: 'looks'; looks: Pick<Looks, 'surface' | 'materials'> | null }
  /** Whether the model turns by itself, until it is turned by hand. */
  | { type: 'turning'; turning: boolean }
  | ({ type: 'turn' } & Turn)
  /** The pieces of the model that is shown, which can be folded and unfolded from now on. */
  | ({ type: 'folding' } & Folding)
  /** How far they are, from 0 (flat, side by side) to 1 (the model), which is where they begin. */
  | { type: 'time'; time: number };

/** A face that was pointed at. */
export interface Pointed {
  /** -1 if there is none that belongs to a part. */
  face: number;
  why: Pointing;
}

/** Faces that were painted in the colour of a part. */
export interface Painted {
  part: number;
  faces: number[];
}

/** What a picture of a model answers: the face that was pointed at, or what was painted. */
export type ModelAnswer = (Pointed & { faces?: never }) | Painted;
