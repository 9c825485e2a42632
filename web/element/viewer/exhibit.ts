/** What a viewer shows: a model, its pieces, and pictures of its nets. */
import type { Piece } from '../../model/job.js';
import type { FoldedNets } from '../../read/fold/folded-nets.js';

/** A picture of a sheet, or of several side by side. */
export type NetPicture =
  /** The SVG that would be printed, with the sheet's number from 0. */
  | { kind: 'sheet'; svg: string; sheet: number }
  /** Pieces without flaps, as they lie. */
  | { kind: 'pattern'; pieces: readonly Piece[] };

export interface Exhibit extends FoldedNets {
  /** Of its file, without ending. */
  title: string;
  nets: readonly NetPicture[];
  sheets: number;
}
