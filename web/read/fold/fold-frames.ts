/** The frames of FOLD files (1.2). Nothing in them is trusted: what is wrong is told with its place. */
import type { ModelFile } from '../../model/model-files.js';
import type { FoldFault } from '../../words/messages.js';
import { unreadable, type Unreadable } from '../unreadable.js';
import { jsonFault } from './json-fault.js';

/** Far more than any paper model has. */
const mostEntries = 4_000_000;

/** Frames that inherit from each other: some hold the steps of a folding, each one made of the one before. */
const mostFrames = 10_000;

type Fields = Readonly<Record<string, unknown>>;

export function badFold(file: string, fault: FoldFault): Unreadable {
  return unreadable('bad-fold', { file, ...fault });
}

function isFields(value: unknown): value is Fields {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** A frame, or an object in one; hands out what is in it in the types that it must have. */
export class FoldFrame {
  /**
   * @param file name of the file
   * @param frame number of the frame: 0 is the key frame, the others are those of `file_frames`
   */
  constructor(
    private readonly file: string,
    readonly frame: number,
    private readonly fields: Fields,
  ) {}

  has(key: string): boolean {
    return this.fields[key] !== undefined;
  }

  /** Whether it is of a class, such as "foldedForm". */
  isOf(name: string): boolean {
    const classes = this.fields['frame_classes'];
    return Array.isArray(classes) && classes.includes(name);
  }

  /** Null if it is absent or no text. */
  text(key: string): string | null {
    const value = this.fields[key];
    return typeof value === 'string' ? value : null;
  }

  /** An object in the frame. */
  object(key: string): FoldFrame {
    const value = this.fields[key];
    if (!isFields(value)) throw this.missing(key);
    return new FoldFrame(this.file, this.frame, value);
  }

  list(key: string): readonly unknown[] {
    const value = this.fields[key];
    if (!Array.isArray(value)) throw this.missing(key);
    if (value.length > mostEntries) throw this.wrongLength(key, value.length, mostEntries);
    return value;
  }

  /** Lists of so many numbers each, one after the other. */
  numbers(key: string, width: number): Float64Array {
    return this.rows(key, width, (entry, value) => this.number(key, entry, value));
  }

  /** Numbers, with NaN where the file has null. */
  numbersOrNull(key: string): Float64Array {
    return Float64Array.from(this.list(key), (value, entry) =>
      this.numberOrNull(key, entry, value),
    );
  }

  /** Lists of so many numbers or nulls, which become NaN, one after the other. */
  numberRowsOrNull(key: string, width: number): Float64Array {
    return this.rows(key, width, (entry, value) => this.numberOrNull(key, entry, value));
  }

  /** A list of numbers. */
  values(key: string): Float64Array {
    return Float64Array.from(this.list(key), (value, entry) => this.number(key, entry, value));
  }

  /** Whole numbers from 0 to below `count`. */
  indices(key: string, count: number): Int32Array {
    return Int32Array.from(this.list(key), (value, entry) => this.index(key, entry, value, count));
  }

  /** Lists of so many of them each, one after the other. */
  indexRows(key: string, width: number, count: number): Int32Array {
    const flat = this.numbers(key, width);
    return Int32Array.from(flat, (value, at) =>
      this.index(key, Math.floor(at / width), value, count),
    );
  }

  /** Lists of at least so many of them. */
  indexLists(key: string, least: number, count: number): number[][] {
    return this.list(key).map((row, entry) => {
      if (!Array.isArray(row) || row.length < least) {
        throw this.fault({ what: 'list', key, entry, least });
      }
      return row.map((value) => this.index(key, entry, value, count));
    });
  }

  /** A whole number from 0 to below `count`. */
  wholeNumber(key: string, count: number): number {
    if (!this.has(key)) throw this.missing(key);
    return this.index(key, 0, this.fields[key], count);
  }

  /** Throws unless a list has so many entries. */
  checkLength(key: string, expected: number): void {
    const { length } = this.list(key);
    if (length !== expected) throw this.wrongLength(key, length, expected);
  }

  /** @param fault something that is wrong in this frame */
  fault(fault: FoldPlace): Unreadable {
    return badFold(this.file, { ...fault, frame: this.frame });
  }

  private missing(key: string): Unreadable {
    return this.fault({ what: this.has(key) ? 'type' : 'missing', key });
  }

  private rows(
    key: string,
    width: number,
    numberOf: (entry: number, value: unknown) => number,
  ): Float64Array {
    const rows = this.list(key);
    const flat = new Float64Array(width * rows.length);
    rows.forEach((row, entry) => {
      if (!Array.isArray(row) || row.length !== width) {
        throw this.fault({ what: 'numbers', key, entry, width });
      }
      row.forEach((value, k) => (flat[width * entry + k] = numberOf(entry, value)));
    });
    return flat;
  }

  private wrongLength(key: string, length: number, expected: number): Unreadable {
    return this.fault({ what: 'length', key, length, expected });
  }

  private number(key: string, entry: number, value: unknown): number {
    // JSON has no NaN, but a number that is too large becomes infinite.
    if (typeof value === 'number' && Number.isFinite(value)) return value;
    throw this.fault({ what: 'number', key, entry });
  }

  private numberOrNull(key: string, entry: number, value: unknown): number {
    return value === null ? NaN : this.number(key, entry, value);
  }

  private index(key: string, entry: number, value: unknown, count: number): number {
    const index = this.number(key, entry, value);
    if (Number.isInteger(index) && index >= 0 && index < count) return index;
    throw this.fault({ what: 'index', key, entry, index, count });
  }
}

/** What is wrong in a frame that is named elsewhere. */
type FoldPlace = FoldFault extends infer Fault
  ? Fault extends { frame: number }
    ? Omit<Fault, 'frame'>
    : never
  : never;

/** The fields of each frame with those that it inherits. */
function inherited(frames: readonly Fields[]): Fields[] {
  const whole: Fields[] = [];
  for (const frame of frames) {
    const parent = frame['frame_inherit'] === true ? Number(frame['frame_parent']) : NaN;
    // A parent comes before its children, as the format wants it: so there are no circles.
    whole.push({ ...whole[parent], ...frame });
  }
  return whole;
}

/**
 * All frames of a file, the key frame first, each with what it inherits.
 *
 * @throws Unreadable for what is no JSON, or no object with frames
 */
export function foldFrames({ name, bytes }: ModelFile): FoldFrame[] {
  const text = new TextDecoder().decode(bytes);
  let file: unknown;
  try {
    file = JSON.parse(text);
  } catch {
    throw badFold(name, jsonFault(text));
  }
  if (!isFields(file)) throw badFold(name, { what: 'no-object' });
  const { file_frames: others = [], ...key } = file;
  if (!Array.isArray(others) || others.length > mostFrames) {
    throw badFold(name, { what: 'type', key: 'file_frames', frame: 0 });
  }
  const strange = others.findIndex((frame) => !isFields(frame));
  if (strange !== -1) throw badFold(name, { what: 'no-frame', frame: strange + 1 });
  const fields = inherited([key, ...(others as Fields[])]);
  return fields.map((frame, number) => new FoldFrame(name, number, frame));
}
