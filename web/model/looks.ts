/**
 * How a model's surface looks, as its files say: colours and pictures, and where on the surface they lie. Plain data;
 * pictures are as their files hold them, undecoded.
 */
import type { ModelFile } from './model-files.js';

/** The surface that looks are given for. Corners are counted face by face, three of each. */
export interface LookedSurface {
  /**
   * The surface as it was before it was simplified, at its finished size and in the coordinates of `JobResult.model`;
   * null if that is the model's own, face by face and corner by corner.
   */
  original: { vertices: Float64Array; faces: Int32Array } | null;
  /**
   * 2 per corner: its place in pictures, (0, 0) at their lower left, (1, 1) at their upper right, as the files have
   * it: any number, and NaN where a face has none. Null if no face has one.
   */
  places: Float32Array | null;
  /** 3 per corner: red, green and blue as screens show them (sRGB), 0 to 255. Null if no face has colours of its own. */
  colours: Uint8Array | null;
  /** Per face: index in `Looks.materials`, -1 for none. Null if no face has a material. */
  materials: Int32Array | null;
}

/** A surface at its finished size, in the coordinates of `JobResult.model`. */
export type OriginalSurface = NonNullable<LookedSurface['original']>;

/** The surface of a result's model as it was before it was simplified; null if it was not, or nobody has asked for it. */
export function originalOf({
  looks,
  original,
}: {
  looks?: Looks;
  original?: OriginalSurface;
}): OriginalSurface | null {
  return looks?.surface.original ?? original ?? null;
}

/** What a picture does beyond its edges. */
export type Wrap = 'repeat' | 'mirror' | 'clamp';

/** What faces are made of. */
export interface Material {
  name: string;
  /** Red, green and blue (sRGB), 0 to 255. Picture and colours of corners are multiplied by it. */
  colour: readonly [number, number, number];
  /** Index in `Looks.pictures`; null for one without. */
  picture: number | null;
  /** To the right and up. */
  wrap: readonly [Wrap, Wrap];
  /** Places are multiplied by the scale, then moved, before the picture is looked up. */
  scale: readonly [number, number];
  offset: readonly [number, number];
}

/** Everything that files say of how a model looks. */
export interface Looks {
  surface: LookedSurface;
  materials: readonly Material[];
  /** PNG, JPEG or whatever else the files hold, with the names that people know. */
  pictures: readonly ModelFile[];
}

/** Materials and pictures of a model whose faces have numbers of materials. */
export type LookedFiles = Pick<Looks, 'materials' | 'pictures'>;

/** What the engine reads of a model's looks. What lies in other files it only names. */
export interface EngineLooks {
  surface: LookedSurface;
  /** What faces call their materials, in the order of their numbers; empty where the file has numbers only. */
  materialNames: readonly string[];
  /** Where these are described: the rest of each `mtllib` line of an OBJ file, with one name or several. */
  libraries: readonly string[];
}
