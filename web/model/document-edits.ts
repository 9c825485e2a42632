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
  /**
   * `first`: on the face at the left of the way from v to w, seen from outside. Without a height the one that was asked
   * for before stays; `auto` without one forgets both.
   */
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

/** What a field should have been. */
export type FieldFault =
  | { expected: 'number' | 'text' | 'flag' | 'options' | 'edge' }
  | { expected: 'whole' | 'list'; least: number }
  | { expected: 'one-of'; words: readonly string[] };

/** Why something is no list of edits; edits count from 1. Its words are in `web/words/en/edit-lists.ts`. */
export type EditFault =
  | { what: 'no-list' }
  | { what: 'no-object'; edit: number }
  | { what: 'no-kind'; edit: number; kind: string; kinds: readonly string[] }
  | { what: 'no-field'; edit: number; kind: string; field: string }
  | ({ what: 'field'; edit: number; kind: string; field: string } & FieldFault);

type Check = (value: unknown) => FieldFault | null;

const isWhole = (value: unknown, least: number): boolean =>
  Number.isInteger(value) && (value as number) >= least;

function check(expected: FieldFault, isRight: (value: unknown) => boolean): Check {
  return (value) => (isRight(value) ? null : expected);
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const number = check({ expected: 'number' }, Number.isFinite);
const whole = (least: number): Check =>
  check({ expected: 'whole', least }, (value) => isWhole(value, least));
const fromOne = whole(1);
const fromZero = whole(0);
const text = check({ expected: 'text' }, (value) => typeof value === 'string');
const flag = check({ expected: 'flag' }, (value) => typeof value === 'boolean');
const record = check({ expected: 'options' }, isRecord);
const edge = check(
  { expected: 'edge' },
  (value) => Array.isArray(value) && value.length === 2 && value.every((v) => isWhole(v, 0)),
);
const listOf = (least: number, item: Check): Check =>
  check(
    { expected: 'list', least },
    (value) =>
      Array.isArray(value) && value.length >= least && value.every((one) => item(one) === null),
  );
const oneOf = (words: readonly string[]): Check =>
  check({ expected: 'one-of', words }, (value) => (words as readonly unknown[]).includes(value));
const side = oneOf(['first', 'second', 'both', 'none', 'auto']);
const lockKind = oneOf(['fold', 'cut', 'free']);

interface Shape {
  needs: Readonly<Record<string, Check>>;
  may?: Readonly<Record<string, Check>>;
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

/** What is wrong with the fields of an edit. */
function fieldFault(
  fields: Readonly<Record<string, unknown>>,
  { needs, may }: Shape,
  edit: number,
): EditFault | null {
  const kind = String(fields['kind']);
  const given = Object.keys(fields).filter((name) => name !== 'kind' && !(name in needs));
  for (const field of [...Object.keys(needs), ...given]) {
    const isRight = needs[field] ?? may?.[field];
    if (!isRight) return { what: 'no-field', edit, kind, field };
    const fault = isRight(fields[field]);
    if (fault !== null) return { what: 'field', edit, kind, field, ...fault };
  }
  return null;
}

function faultOf(value: unknown, edit: number): EditFault | null {
  if (!isRecord(value)) return { what: 'no-object', edit };
  const kind = String(value['kind']);
  const shape = (shapes as Record<string, Shape | undefined>)[kind];
  if (!shape) return { what: 'no-kind', edit, kind, kinds: Object.keys(shapes) };
  return fieldFault(value, shape, edit);
}

/** What is wrong with a list of edits that comes from a file or another program; null if it is one. */
export function editsFault(value: unknown): EditFault | null {
  if (!Array.isArray(value)) return { what: 'no-list' };
  for (const [index, edit] of value.entries()) {
    const fault = faultOf(edit, index + 1);
    if (fault !== null) return fault;
  }
  return null;
}
