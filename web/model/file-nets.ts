/** The nets that a model's file brings along, in terms of the file's own faces. */
export interface FileNets {
  /** 3 per vertex, in the axes of the file. */
  positions: Float64Array;
  /** Per face: where its corners begin; and their number at last. */
  firstCorners: Int32Array;
  /** Per corner: its vertex. Corners are counter-clockwise, seen from outside. */
  vertices: Int32Array;
  /** Per corner: 1 if the net goes on across the edge that begins there. */
  joined: Uint8Array;
  /** Per corner: height in mm of the flap that this side of the edge bears where it is cut; 0 for none. */
  flaps: Float64Array;
  /** Millimetres on paper per unit of the file. */
  scale: number;
  /** Width and height of each piece on paper in mm, flaps included. */
  pieces: readonly (readonly [number, number])[];
}
