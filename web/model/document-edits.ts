/** What a person changes in a result, as programs, projects and the command line write it down. */
import type { EdgeName } from './job.js';

/**
 * A change. Parts, pieces and sheets count from 1; edges are two vertices of the repaired model, faces
 * are its faces, both as in the FOLD file's folded form.
 */
export type DocumentEdit =
  | { kind: 'split'; part: number; into: number }
  | { kind: 'merge'; parts: readonly number[] }
  /** Moves faces to another part. */
  | { kind: 'assign'; faces: readonly number[]; part: number }
  | { kind: 'cut'; edge: EdgeName }
  /**
   * Glues a cut edge together again. In one piece the loop is opened at `open`, or where that leaves
   * least to glue; with `search` two pieces that would overlap are searched another net.
   */
  | { kind: 'join'; edge: EdgeName; open?: EdgeName; search?: boolean }
  /**
   * From now on the edge is always a fold, always cut, or whatever suits. A cut is joined for it, as by
   * `join`; a fold is cut, and the piece held together elsewhere if it can be.
   */
  | { kind: 'lock'; edge: EdgeName; as: LockKind }
  /** Searches a part again from another seed. */
  | { kind: 'again'; part: number; seed: number }
  /** `first`: on the face at the left of the way from v to w, seen from outside. */
  | { kind: 'flap'; edge: EdgeName; side: FlapChoiceSide; height_mm?: number }
  /** A piece stays at this place: the lower left corner of its box, and its turn. */
  | { kind: 'place'; piece: number; sheet: number; x_mm: number; y_mm: number; turn_deg: number }
  | { kind: 'unpin'; piece: number }
  /** An empty text takes the name away. */
  | { kind: 'name'; part: number; text: string }
  /** Options of the command line, by their names; these of sheets, size, flaps and numbers. */
  | { kind: 'paper'; options: Readonly<Record<string, unknown>> }
  /** These of how lines look. */
  | { kind: 'print'; options: Readonly<Record<string, unknown>> };

export type LockKind = 'fold' | 'cut' | 'free';

export type FlapChoiceSide = 'first' | 'second' | 'both' | 'none' | 'auto';

/** A list of edits that is none; the message is for people and names the edit. */
export class BadEdit extends Error {
  override readonly name = 'BadEdit';
}

type Check = (value: unknown) => string | null;

const isWhole = (value: unknown): value is number => Number.isInteger(value);

const number: Check = (value) => (Number.isFinite(value) ? null : 'is not a number');
const fromOne: Check = (value) =>
  isWhole(value) && value >= 1 ? null : 'is not a whole number from 1 on';
const fromZero: Check = (value) =>
  isWhole(value) && value >= 0 ? null : 'is not a whole number from 0 on';
const text: Check = (value) => (typeof value === 'string' ? null : 'is not a text');
const flag: Check = (value) => (typeof value === 'boolean' ? null : 'is neither true nor false');
const record: Check = (value) =>
  typeof value === 'object' && value !== null && !Array.isArray(value) ? null : 'has no options';
const edge: Check = (value) =>
  Array.isArray(value) && value.length === 2 && value.every((v) => isWhole(v) && v >= 0)
    ? null
    : 'is not two vertices';
const listOf =
  (least: number, check: Check): Check =>
  (value) =>
    Array.isArray(value) && value.length >= least && value.every((item) => check(item) === null)
      ? null
      : `is not a list of ${least} or more numbers`;
const oneOf =
  (words: readonly unknown[]): Check =>
  (value) =>
    words.includes(value) ? null : `is none of ${words.join(', ')}`;
const side = oneOf(['first', 'second', 'both', 'none', 'auto']);
const lockKind = oneOf(['fold', 'cut', 'free']);

interface Shape {
  needs: Record<string, Check>;
  may?: Record<string, Check>;
}

/** What each kind of edit is made of. */
const shapes: Record<DocumentEdit['kind'], Shape> = {
  split: { needs: { part: fromOne, into: fromOne } },
  merge: { needs: { parts: listOf(2, fromOne) } },
  assign: { needs: { faces: listOf(1, fromZero), part: fromOne } },
  cut: { needs: { edge } },
  join: { needs: { edge }, may: { open: edge, search: flag } },
  lock: { needs: { edge, as: lockKind } },
  again: { needs: { part: fromOne, seed: fromZero } },
  flap: { needs: { edge, side }, may: { height_mm: number } },
  place: {
    needs: { piece: fromOne, sheet: fromOne, x_mm: number, y_mm: number, turn_deg: number },
  },
  unpin: { needs: { piece: fromOne } },
  name: { needs: { part: fromOne, text } },
  paper: { needs: { options: record } },
  print: { needs: { options: record } },
};

function faultOf(edit: unknown): string | null {
  if (record(edit) !== null) return 'is no object';
  const fields = edit as Record<string, unknown>;
  const shape = (shapes as Record<string, Shape | undefined>)[String(fields['kind'])];
  if (!shape) {
    return `has the kind '${String(fields['kind'])}', which is none of ${Object.keys(shapes).join(', ')}`;
  }
  for (const [name, check] of Object.entries(shape.needs)) {
    const fault = check(fields[name]);
    if (fault !== null) return `(${String(fields['kind'])}): '${name}' ${fault}`;
  }
  for (const [name, value] of Object.entries(fields)) {
    if (name === 'kind' || name in shape.needs) continue;
    const check = shape.may?.[name];
    if (!check) return `(${String(fields['kind'])}): there is no '${name}'`;
    const fault = check(value);
    if (fault !== null) return `(${String(fields['kind'])}): '${name}' ${fault}`;
  }
  return null;
}

/**
 * Edits as they come from a file or another program.
 * @throws BadEdit that names the first one that is none, counted from 1
 */
export function readEdits(value: unknown): DocumentEdit[] {
  if (!Array.isArray(value)) throw new BadEdit('the edits are no list');
  value.forEach((edit: unknown, index) => {
    const fault = faultOf(edit);
    if (fault !== null) throw new BadEdit(`edit ${index + 1} ${fault}`);
  });
  return value as DocumentEdit[];
}
