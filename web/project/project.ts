/** A document as it is kept: plain values, from which another session goes on where one has ended. */
import type { DocumentEdit } from '../model/document-edits.js';
import type { JobResult, JobStart } from '../model/job.js';
import type { EdgeLock, FlapChoice, PartName, PinnedPiece } from '../model/job-options.js';
import type { Message } from '../model/message.js';
import type { ModelFiles } from '../model/model-files.js';
import type { StageSeconds } from '../model/stage-seconds.js';

/** Options by the command line's names, with values that its parsers take. */
export type WrittenSettings = Readonly<Record<string, unknown>>;

/** Where the last stage of a job begins. */
export type SavedStart = Pick<JobStart, 'labels' | 'nets' | 'paper'>;

/**
 * A result by what it is made of: in most cases the last stage gives it again, to the same bits, and takes
 * milliseconds. Whether it does, the hash says.
 */
export interface SavedState {
  hash: string;
  /** All that was asked for then. */
  options: WrittenSettings;
  flapEdges: readonly FlapChoice[];
  locks: readonly EdgeLock[];
  names: readonly PartName[];
  pins: readonly PinnedPiece[];
  start: SavedStart;
  /** What the last stage alone does not know. */
  told: { search: JobResult['search']; seconds: StageSeconds; notices: readonly Message[] };
  /** There if its job was stopped: these nets are all that it has, and none is searched to make it again. */
  isStopped?: true;
}

export interface Project {
  /** Version of the program that has written it. */
  app: string;
  /** What a person calls it. */
  name: string;
  files: ModelFiles;
  /** Of the run. */
  options: WrittenSettings;
  /** All edits, those that were undone as well, by the calls that have made them. */
  steps: readonly (readonly DocumentEdit[])[];
  /** Steps that are not undone. */
  cursor: number;
  /** Before the first step, and after each; null where only making it again leads there. */
  states: readonly (SavedState | null)[];
}

/** A project as it was read, and what a person must know of it. */
export interface ReadProject {
  project: Project;
  faults: readonly Message[];
}

/** The newest version of the format; whatever is added to it without harm to older programs does not count. */
export const formatVersion = 1;

/** Says in the project itself what it is. */
export const formatName = 'foldwright-project';

/** Where everything lies in the archive. */
export const places = {
  document: 'project.json',
  results: 'results.json',
  files: 'files/',
} as const;

/** How files with projects end. */
export const projectEnding = '.foldwright';
