/** What both builds of the package offer beside `open` and `unfold`. */
export type { TimedResult } from '../core/client.js';
export { JobError } from '../core/job-error.js';
export type { Pool } from '../core/pool.js';
export type { TimedEvent } from '../core/protocol.js';
export { exportFormats, type ExportFormat, type WrittenFile } from '../export/formats.js';
export type { Report } from '../export/report.js';
export type { DocumentEdit } from '../model/document-edits.js';
export { BadEdit, readEdits } from './read-edits.js';
export type { JobResult } from '../model/job.js';
export type { ModelFile, ModelFiles } from '../model/model-files.js';
export { BadOption } from '../words/bad-option.js';
export type { Options } from './written-options.js';
export type { Door, OpenOptions, Unfolded } from './door.js';
export type { Inspection } from './inspect.js';
export type { Applied, Refusal } from './edit-plan.js';
export { Session } from './session.js';
export type { RunWork, WorkOptions } from './work.js';
