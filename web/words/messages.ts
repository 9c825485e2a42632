/**
 * What people are told, as codes with typed parameters: by the engine (`cpp/mesh/message_codes.h`) and by
 * the programs around it. Where a code has several sentences, `what` says which.
 */

import type { FileExcess } from '../model/model-files.js';
import type { ValueFault } from '../model/option-values.js';
import type { PixelExcess } from '../model/pixels.js';
import type { RepairStep } from '../model/repair-steps.js';

type None = Record<never, never>;
type Counted = { count: number };
/** Where something stands in a file: line 23. */
type At = { place: 'line' | 'vertex' | 'face' | 'element' | 'triangle' | 'count'; at: number };
type Stage = 'read' | 'learn' | 'cluster' | 'search' | 'compact' | 'paper';
/** What is wrong with an option is seen here before the engine sees it. */
export type OptionFault =
  | { what: 'no-option' | 'fixed'; option: string }
  | ({ what: 'value'; option: string; value: string } & ValueFault)
  | { what: 'second-size'; option: string; first: string }
  | { what: 'no-paper-left'; option: string; margin_mm: number; paper: string }
  | ({ what: 'pixels' } & PixelExcess);

type Bounded<What extends string> = { what: What; least: number; most: number };

/** Parameters by the codes of the engine. */
export interface EngineMessages {
  'bad-header':
    | ({
        what: 'property-type' | 'encoding' | 'ply-magic' | 'off-magic' | 'keyword';
        word: string;
      } & At)
    | ({ what: 'element-count'; element: string } & At)
    | ({ what: 'property-first' | 'no-format' } & At)
    | ({ what: 'counts' } & Partial<At>)
    | { what: 'dimensions'; dimensions: number }
    | { what: 'property'; element: string; property: string };
  'bad-index': { index: number; vertices: number } & At &
    ({ what: 'beyond'; first: number } | { what: 'before' });
  'bad-number': { what: 'comma' | 'number' | 'whole'; word: string } & At;
  'bad-size': { least: number; most: number };
  'bad-syntax': { word: string; expected: string } & At;
  'bad-text': At;
  'empty-file': None;
  'no-area': { what: 'point' | 'faces' };
  'no-faces': { what: 'nothing' | 'vertices' | 'surfaces' | 'model' };
  'no-model': Counted;
  'several-models': Counted & { first: string; second: string };
  'not-finite': { what: 'coordinate' | 'weight' } & At;
  'too-many-corners': { face: number; corners: number; most: number };
  truncated:
    | ({ what: 'number' | 'coordinates' | 'corners' | 'face' | 'ply-header' | 'more' } & At)
    | { what: 'stl-header'; bytes: number }
    | ({ what: 'triangles'; announced: number } & At)
    | ({ what: 'element'; announced: number; element: string } & At)
    | ({ what: 'keyword'; expected: string } & At)
    | ({ what: 'vertices' | 'faces'; done: number; announced: number } & At)
    | ({ what: 'header-only' } & Partial<At>);
  'unknown-format':
    | { what: 'contents'; format: string }
    | { what: 'file'; file: string; format: string }
    | { what: 'ending'; ending: string }
    | { what: 'nothing' };

  'closed-cracks': Counted & { width: number };
  'lost-picture-places': Counted;
  'closed-t-junctions': Counted;
  /** And how many of the pairs can be united. */
  'crossing-bodies': Counted & { unitable: number };
  'crossings-unchecked': Counted;
  'counts-from-zero': Counted;
  'cut-nonorientable': Counted;
  'cut-off': Counted & Partial<At>;
  'decimal-commas': Counted;
  'dropped-degenerate-faces': Counted;
  'dropped-duplicate-faces': Counted;
  /** And of how many faces of the file they are made. */
  'dropped-inner-bodies': Counted & { faces: number };
  'dropped-misnumbered-faces': Counted & At;
  'dropped-placeless-faces': Counted & At;
  'dropped-unused-vertices': Counted;
  'filled-holes': Counted;
  'flat-bodies': Counted;
  'flattened-faces': Counted & { distance: number };
  'flipped-faces': Counted;
  'halved-edges': Counted;
  /** And how many edges a hole may have that is filled. */
  'huge-holes': Counted & { edges: number };
  'ignored-elements': Counted & { points: number; lines: number; curves: number; surfaces: number };
  'inner-bodies': Counted;
  'merged-two-sided': Counted;
  'missing-endsolid': Counted;
  /** And how many of them are open. */
  'not-united': Counted & { open: number };
  /** And on the borders of how many bodies. */
  'open-border': (Counted & { gap: number; bodies: number; what?: never }) | { what: 'edge' };
  /** How wide the widest is, how many are small, and what that means: in percent of the model's longest side. */
  'open-holes': Counted & { percent: number; small: number; small_percent: number };
  'other-format': { ending: string; format: string };
  'self-crossing-bodies': Counted;
  'split-nonmanifold-edges': Counted;
  'split-nonmanifold-vertices': Counted;
  /** Of a step that is switched off: to how many things it would have been done. */
  'step-off': Counted & { what: RepairStep };
  'trailing-bytes': Counted;
  'trailing-lines': Counted;
  'triangulated-polygons': Counted;
  'unfilled-holes': Counted;
  /** And how many faces of the file nothing is left of. */
  'united-bodies': Counted & { faces: number };
  'welded-vertices': Counted;
  'wrong-count': Counted & { announced: number };

  'bad-edit':
    | { what: 'no-part-named' }
    | { what: 'no-part'; part: number; parts: number }
    | { what: 'twice'; part: number }
    | { what: 'apart'; parts: number[] }
    | { what: 'into'; parts: number[]; into: number; most: number };
  'bad-margin': None;
  'bad-option':
    | { what: 'height' | 'width' | 'depth' | 'scale' | 'paper' | 'pin-sheet'; most: number }
    | { what: 'parts' | 'proxy' | 'faces' | 'margin'; least: number }
    | Bounded<
        'sheets' | 'flaps' | 'flap-height' | 'flap-angle' | 'runs' | 'clearance' | 'fill-holes'
      >
    | { what: 'repair'; step: string }
    | { what: 'names-of-part' | 'pin-piece' | 'pin-place' }
    | { what: 'name-control' | 'name-colon' | 'name-length' | 'name-number' }
    | { what: 'same-name'; name: string }
    | { what: 'flap-edge'; from: number; to: number }
    | { what: 'unreadable' | 'written'; detail: string }
    | OptionFault;
  'bad-pin':
    | { what: 'outside'; piece: string; sheet: number }
    | { what: 'overlap'; pieces: string[]; sheet: number };
  'bad-start': None;
  'face-too-large': {
    face_width_mm: number;
    face_height_mm: number;
    width_mm: number;
    height_mm: number;
    share: number;
  };
  internal: { what: Stage; detail: string };
  'no-depth': None;
  'no-height': None;
  'no-width': None;
  'out-of-memory': { what: Stage | 'file' };
  'too-few-sheets': None;
  'too-many-faces': { faces: number; most: number; proposed: number };

  'already-cut': None;
  'already-joined': None;
  'inside-panel': None;
  locked: { what: 'fold' | 'cut' | 'faces' | 'loop' } | { what: 'parts'; parts: number };
  'no-edge': { from: number; to: number };
  'no-face': { what: 'none' } | { what: 'beyond'; most: number };
  'no-net': None;
  'no-part': { part: number; parts: number };
  'not-in-loop': None;
  'not-touching': { what: 'faces'; part: number };
  overlap: { what: 'pieces' | 'loop' };
  'would-fall-apart': { what: 'faces' | 'fold'; part: number };

  'colour-numbers': None;
  'files-ignored': { files: string[] };
  'faces-above-wish': { faces: number };
  joints: Counted & { what: 'numbered' | 'bare' };
  'joints-lost': Counted;
  'large-model': { faces: number; seconds: number; proposed: number };
  'meets-itself': { part: number };
  'no-motion': { part: number };
  'part-split': { what: 'no-motion' | 'no-net'; part: number; pieces: number };
  'parts-lowered': { panels: number };
  'parts-raised':
    | { what: 'bodies'; bodies: number }
    | { what: 'pieces'; parts: number; pieces: number; instead: number };
  'pin-lost': Counted;
  'small-bodies': { count: number; faces: number; limit_mm: number };
  'smaller-saves-sheets': {
    what: 'height' | 'width' | 'depth';
    size_mm: number;
    instead_mm: number;
    sheets: number;
    of: number;
  };
  'sheet-split': { part: number; pieces: number };
  'unchecked-pieces': { what: 'off' | 'cancelled' | 'kept' | 'huge' | 'large'; pieces: string[] };
  'unit-guessed': { unit: 'mm' | 'cm' | 'm' | 'in' };
  'up-guessed': None;
  'weak-necks': { pieces: string[] };
}

/** Why an archive gives no files. */
export type ArchiveFault =
  { what: 'damaged' | 'bomb' } | { what: 'locked' | 'method'; entry: string } | FileExcess;

/** Why a glTF file gives no model. */
export type GltfFault =
  | { what: 'truncated' | 'json' | 'structure' | 'cycle' }
  | { what: 'version'; version: string }
  | { what: 'extension'; extension: string }
  | { what: 'short-buffer'; buffer: string; bytes: number; announced: number };

/** Why a 3MF package gives no model. */
export type ThreeMfFault =
  | { what: 'no-model' | 'nothing' | 'sliced' }
  | { what: 'no-part'; part: string }
  | { what: 'no-object'; part: string; object: string }
  | { what: 'cycle'; object: string }
  | { what: 'xml'; part: string; line: number }
  | { what: 'word'; part: string; line: number; word: string };

/** Why a Pepakura file gives no model. */
export type PdoFault =
  | { what: 'locked' | 'hidden' | 'no-faces' | 'old' }
  | { what: 'version'; version: number }
  /** At which byte. */
  | { what: 'damaged'; at: number };

/**
 * Why a FOLD file gives no model. Frames and entries of lists count from 0, as in the format: frame 0 is the key frame,
 * and frame 1 the first of `file_frames`.
 */
export type FoldFault =
  /** What there is in place of a model in space. */
  | { what: 'pattern' | 'flat' | 'nothing' }
  | { what: 'cut-off' | 'no-object' }
  | { what: 'word'; line: number; character: number; word: string }
  | { what: 'no-frame'; frame: number }
  | { what: 'missing' | 'type' | 'times'; frame: number; key: string }
  | { what: 'length'; frame: number; key: string; length: number; expected: number }
  | ({ frame: number; key: string; entry: number } & FoldEntryFault);

/** What is wrong with an entry of a list in a FOLD file. */
export type FoldEntryFault =
  | { what: 'number' | 'letter' }
  | { what: 'numbers'; width: number }
  | { what: 'list'; least: number }
  | { what: 'index'; index: number; count: number }
  | { what: 'twice'; index: number };

/** Why a project cannot be opened. */
export type ProjectFault = { what: 'damaged' } | { what: 'newer'; version: number };

/** Parameters by the codes of what is found in TypeScript. */
export interface OwnMessages {
  'bad-3mf': { file: string } & ThreeMfFault;
  'bad-archive': { file: string } & ArchiveFault;
  'bad-fold': { file: string } & FoldFault;
  'bad-gltf': { file: string } & GltfFault;
  'bad-pdo': { file: string } & PdoFault;
  'bad-project': { file: string } & ProjectFault;
  'missing-files': { file: string; missing: string[] };
  'reader-not-loaded': None;
  'uniter-not-loaded': None;
  'no-model-in-archive': { file: string; files: string[] };
  'too-many-triangles': { most: number };

  'broken-faces': Counted;
  'damaged-extras': None;
  'damaged-looks': None;
  'large-pictures': { files: string[]; most: number; most_mb: number; most_pixels: number };
  'lost-looks': Counted;
  'missing-looks': { what: 'pictures' | 'libraries'; files: string[] };
  'picture-guessed': { file: string };
  'simplified-looks': None;
  'unknown-materials': { names: string[] };
  'unread-libraries': { files: string[] };
  'unread-pictures': { files: string[]; kinds: string[] };

  'archive-choice': { file: string; others: string[] };
  'not-for-printing': { supports: number; modifiers: number; negatives: number; unprinted: number };
  /** What was found until then is there. */
  'run-stopped': None;
  'file-nets-kept': { pieces: number; uncut: number; size: 'file' | 'other' };
  'file-nets-lost': { what: 'none' | 'simplified' | 'repaired' | 'flat' };
  'file-nets-unused': { pieces: number };
  /** Of a run that keeps the nets of its file. */
  'parts-unused': { parts: number };
  'fold-nets-unused': { pieces: number };
  'pdo-unused': { hidden: number; texts: number; images: number };
  'posed-skins': Counted;
  'unknown-extensions': { names: string[] };
  'unused-content': {
    animations: number;
    morphs: number;
    uvs: number;
    cameras: number;
    instances: number;
  };

  'project-damaged':
    | { what: 'document' }
    | { what: 'files'; files: string[] }
    | ({ what: 'edits' | 'refused' } & Counted);
  'project-options-lost': { options: string[] };
  'project-redrawn': None;
  'engine-died': { reason: string; times?: number };
  'edit-place-gone': { what: 'edge' | 'faces' | 'part' | 'piece' };
  overtaken: None;
  'no-piece': { piece: number; pieces: number };
  'not-pinned': { piece: number };
  'not-together': None;
  'no-legend': None;
  /** And the margin with which nothing runs over it. */
  'beyond-page': { by_mm: number; margin_mm: number };
  'missing-glyphs': { letters: string[] };
  'fonts-not-loaded': None;
  'no-looks': None;
  'pictures-unreadable': { what: 'format' | 'damaged' | 'large'; files: string[] };
  'pictures-not-loaded': None;
  'marks-not-free': { pieces: string[]; margin_mm: number };
  'missing-names': { pieces: string[] };
  'missing-flaps': Counted & {
    narrow: number;
    thin: number;
    blocked: number;
    short: number;
    /** Of the length of all seams. */
    percent: number;
    /** How many of them have loose strips. */
    strips: number;
    pieces: string[];
  };
  'missing-numbers': { seams: string[] };
  'overlapping-pieces': { pieces: string[] };
  /** With the size and the number of faces at which they are long enough, if there are any. */
  'short-seams': {
    median_mm: number;
    height?: number;
    width?: number;
    depth?: number;
    faces?: number;
  };
  'empty-sheet': { sheet: number; percent: number; pieces: string[] };
  'tiny-pieces': { pieces: string[] };
  'equal-pieces': { pieces: string[] };
  'cricut-area': { sheets: number[]; width_mm: number; height_mm: number; margin_mm: number };
}

export interface Messages extends EngineMessages, OwnMessages {}

export type Code = keyof Messages;

/** A message whose code is known. */
export type KnownMessage = { [Name in Code]: { code: Name; params: Messages[Name] } }[Code];

/** One function per code, from its parameters to a phrase. */
export type Table = { readonly [Code in keyof Messages]: (params: Messages[Code]) => string };
