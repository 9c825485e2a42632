/** Solids on their way through a library that unites them. */

/** A closed surface; its hollows belong to it. */
export interface Solid {
  /** 3 per vertex. */
  positions: Float64Array;
  /** 3 per face, counter-clockwise from outside. */
  faces: Int32Array;
}

/** The surface of several solids together. */
export interface UnitedSolids extends Solid {
  /** Per face the one that it is all or a share of, counted through all solids in a row. */
  sources: Int32Array;
}

/** Unites solids about 1 across; null where it cannot. The same solids give the same bits. */
export type SolidUniter = (solids: readonly Solid[]) => UnitedSolids | null;
