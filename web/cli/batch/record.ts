/** What is remembered of each model in its folder: of what its files were made, and what came out. */
import { createHash } from 'node:crypto';
import { readFileSync, statSync } from 'node:fs';
import { version } from '../../../package.json';
import type { ModelFiles } from '../../model/model-files.js';
import { echo } from '../../model/options.js';
import type { Level } from '../../model/verdict.js';
import type { BatchCommands } from './batch-line.js';
import { placeOf, recordName } from './names.js';

/** Counts up when records of before would be misunderstood. */
const recordVersion = 1;

/** All that the files of a model depend on. */
export interface Origin {
  /** SHA-256 of the model's files with their names; null if they could not be read. */
  input: string | null;
  /** Version of the program. */
  foldwright: string;
  options: Record<string, unknown>;
  /** Names of the options that were written: a project has its own for others. */
  given: string[];
  formats: string[];
}

/** What came out, for pages and programs. */
export interface Summary {
  faces: number;
  parts: number;
  pieces: number;
  sheets: number;
  size_mm: number[];
  /** Seconds that it takes a person to build the model with glue. */
  building: number;
  verdict: { level: Level; text: string };
  /** In words. */
  notices: string[];
  result_hash: string;
}

/** A file of a model, by its name within the model's folder. */
export interface FileNote {
  name: string;
  bytes: number;
}

/** A model that gave nothing: `refused` will be so until it or the options change, `failed` is tried again. */
export interface Fault {
  status: 'refused' | 'failed';
  code: string;
  /** One sentence, without the model's name. */
  text: string;
}

/** A model of which all files are there. */
export interface Success {
  status: 'done';
  files: FileNote[];
  summary: Summary;
}

export type ModelRecord = { version: number; origin: Origin } & (Success | Fault);

/** Identifies files: two models are the same if their files and the names of these are. */
function hashOf(files: ModelFiles): string {
  const hash = createHash('sha256');
  for (const { name, bytes } of files) {
    // Lengths keep names and contents apart.
    hash.update(`${Buffer.byteLength(name)} ${bytes.length} ${name}`).update(bytes);
  }
  return hash.digest('hex');
}

/** @param files null if they could not be read */
export function originOf(
  { formats, given, settings }: Pick<BatchCommands, 'formats' | 'given' | 'settings'>,
  files: ModelFiles | null,
): Origin {
  // Any number of workers gives the same files.
  const { workers: _, ...options } = echo(settings);
  return {
    input: files && hashOf(files),
    foldwright: version,
    options,
    given: [...given].filter((name) => name !== 'workers').sort(),
    formats: [...formats],
  };
}

export function recordOf(origin: Origin, outcome: Success | Fault): ModelRecord {
  return { version: recordVersion, origin, ...outcome };
}

export function recordText(record: ModelRecord): string {
  return `${JSON.stringify(record, null, 2)}\n`;
}

/** The record of a model; null if there is none, or one that is damaged or of another version. */
export function readRecord(out: string, name: string): ModelRecord | null {
  try {
    const text = readFileSync(placeOf(out, name, recordName(name)), 'utf8');
    const record = JSON.parse(text) as ModelRecord;
    return record.version === recordVersion ? record : null;
  } catch {
    return null;
  }
}

/** Whether the files that a record tells of are all there. */
function isComplete(out: string, name: string, files: readonly FileNote[]): boolean {
  return files.every((file) => {
    const status = statSync(placeOf(out, name, file.name), { throwIfNoEntry: false });
    return status?.size === file.bytes;
  });
}

/** Whether a model need not be done again: nothing that its files depend on has changed, and they are there. */
export function isCurrent(
  record: ModelRecord | null,
  origin: Origin,
  place: { out: string; name: string },
): record is ModelRecord {
  if (record === null || record.status === 'failed' || origin.input === null) return false;
  // Settings went through JSON in the record: texts are compared, not objects.
  if (JSON.stringify(record.origin) !== JSON.stringify(origin)) return false;
  return record.status !== 'done' || isComplete(place.out, place.name, record.files);
}
