/** What a document is at one point of its history. */
import type { TimedResult } from '../core/client.js';
import type { JobStart } from '../model/job.js';
import { jobOptions, printOptions, type Settings } from '../model/options.js';
import type {
  EdgeLock,
  FlapChoice,
  JobOptions,
  PartName,
  PinnedPiece,
} from '../model/job-options.js';
import type { PrintOptions } from '../model/print-options.js';

/** All that was asked for; plain values. */
export interface Wishes {
  settings: Settings;
  flapEdges: readonly FlapChoice[];
  locks: readonly EdgeLock[];
  names: readonly PartName[];
  pins: readonly PinnedPiece[];
}

/** What was asked for, and what came of it; never changed. */
export interface DocumentState {
  wishes: Wishes;
  result: TimedResult;
  /** Where the last stage alone may make the result again. */
  start: JobStart;
  /** Whether the job that made it was stopped: it has the nets that there were by then. */
  isStopped: boolean;
}

/** All that was asked for before the first edit. */
export function freshWishes(settings: Settings): Wishes {
  return { settings, flapEdges: [], locks: [], names: [], pins: [] };
}

/** What the engine is asked for. */
export function jobOf({ settings, flapEdges, locks, names, pins }: Wishes): JobOptions {
  return {
    ...jobOptions(settings),
    flapEdges: [...flapEdges],
    locks: [...locks],
    names: [...names],
    pins: [...pins],
  };
}

/** How the sheets shall look. */
export function printOf({ settings }: Wishes): PrintOptions {
  return printOptions(settings);
}

/** Bytes that the arrays of a value hold, roughly; texts and small numbers are not counted. */
export function bytesOf(value: unknown): number {
  if (ArrayBuffer.isView(value)) return value.byteLength;
  if (typeof value !== 'object' || value === null) return 0;
  return Object.values(value).reduce<number>((sum, part) => sum + bytesOf(part), 0);
}
