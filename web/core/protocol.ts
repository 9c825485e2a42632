/**
 * What the main thread and its workers say to each other; types only. One worker conducts a job:
 * it runs what cannot be split and cuts the rest into tasks. It and the helpers, which are the
 * other workers, run the tasks. Workers do not know each other: the main thread passes on what they
 * say, and moves the bytes without looking at them. Jobs and workers are numbered by the main
 * thread, tasks and surfaces by the job.
 */
import type { EngineResult, JobEvent, JobResult, JobStart } from '../model/job.js';
import type { JobOptions } from '../model/job-options.js';
import type { Message } from '../model/message.js';
import type { ModelFiles } from '../model/model-files.js';
import type { StageSeconds } from '../model/stage-seconds.js';
import type { ReadModel } from '../read/read-model.js';

/** A task and all that is needed to run it, anywhere, to the same result. */
export interface TaskOrder {
  task: number;
  bytes: Uint8Array;
  /** Names the surface that the task runs on. */
  surface: number;
  /** The surface itself, unless the worker has had it before. */
  surfaceBytes: Uint8Array | null;
  /** Milliseconds that pass at least between two reports of a worker, but for results. */
  interval: number;
  /** Whether reports show the net under search. */
  pictures: boolean;
}

/** What a task tells. */
export interface TaskReport {
  task: number;
  /** All that has happened since the task's last report. */
  status: Uint8Array;
  /** Null while the task is under way. */
  result: Uint8Array | null;
  /** Milliseconds since the last report that went into making nets fold, or into planning how they do. */
  foldingTime: number;
}

/**
 * To a worker without a job: conduct one. Answered by `events`, of which the last is `done`, `error` or, where
 * nothing is searched, `cancelled`, and meanwhile by `help` and `task`. The files' bytes are copied, so that the asker can run
 * the same ones again.
 */
export interface RunRequest {
  type: 'run';
  job: number;
  files: ModelFiles;
  options: JobOptions;
  /** The earlier result that the job changes, if it does. */
  start: JobStart | null;
  /** The most helpers that there can be at a time. */
  helpers: number;
  pictures: boolean;
  /** Whether `draft` events tell what could be printed already. */
  drafts: boolean;
  /** Whether nets are searched; else the job comes to those of its start, and ends with `cancelled`. */
  searches: boolean;
}

/**
 * To a worker without a job: make a file that the engine reads of a model's files. Answered by `read`. The
 * files' bytes are copied.
 */
export interface ReadRequest {
  type: 'read';
  job: number;
  files: ModelFiles;
}

/** To the conductor: a helper stands by. Answered by a `task` for it once there is one. */
export interface HelperRequest {
  type: 'helper';
  job: number;
  helper: number;
}

/** To the conductor: a helper died. The task that it had, if any, goes to another one. */
export interface LostRequest {
  type: 'lost';
  job: number;
  helper: number;
  /** For people. */
  reason: string;
}

/** To the conductor: passes a helper's report on. With a result the helper stands by again.
 * Transfers the report's bytes. */
export interface ReportRequest {
  type: 'report';
  job: number;
  helper: number;
  report: TaskReport;
}

/** To a helper that stands by: run this. Answered by `report`s. Transfers the order's bytes. */
export interface TaskRequest {
  type: 'task';
  job: number;
  order: TaskOrder;
}

/**
 * To any worker: leave the job and free all of it. Answered by `ended` at the engine's next pause,
 * which may be as far away as its longest step: an asker in a hurry replaces the worker. Before that
 * a conductor answers by `events` with `cancelled`, if its job was not over.
 */
export interface EndRequest {
  type: 'end';
  job: number;
}

export type Request =
  RunRequest | ReadRequest | HelperRequest | LostRequest | ReportRequest | TaskRequest | EndRequest;

/** What a job tells, with the time that only this side of the engine's boundary can measure. */
export type TimedEvent<Result = JobResult> =
  | Exclude<JobEvent, { type: 'stage' | 'notice' | 'error' | 'draft' | 'done' | 'cancelled' }>
  /** `text`: the message in words; there once the event has left the workers, which know no language. */
  | (Extract<JobEvent, { type: 'notice' | 'error' }> & { text?: string })
  | Extract<JobEvent<Result>, { type: 'draft' }>
  /** `seconds` since the job began. */
  | (Extract<JobEvent, { type: 'stage' }> & { seconds: number })
  | (Extract<JobEvent<Result>, { type: 'done' | 'cancelled' }> & { seconds: StageSeconds });

/** The same as it comes from the workers. */
export type TimedEngineEvent = TimedEvent<EngineResult>;

/** Answers `run`, at most ten times a second; transfers the buffers of all typed arrays. */
export interface EventsAnswer {
  type: 'events';
  job: number;
  /** In the order in which they happened. */
  events: TimedEngineEvent[];
}

/** Answers `run` when tasks wait: how many helpers would have something to do. */
export interface HelpAnswer {
  type: 'help';
  job: number;
  wanted: number;
}

/** Answers `helper`, and later `report`: the next task of that helper. Transfers the surface. */
export interface TaskAnswer {
  type: 'task';
  job: number;
  helper: number;
  order: TaskOrder;
}

/** Answers `task`, many times; the last one has the result. Transfers the report's bytes. */
export interface ReportAnswer {
  type: 'report';
  job: number;
  report: TaskReport;
}

/** Answers `read`: the model, whose bytes are transferred, or why there is none. */
export interface ReadAnswer {
  type: 'read';
  job: number;
  model: ReadModel | null;
  failure: Message | null;
}

/** Answers `end`; transfers nothing. Nothing of the job follows. */
export interface EndedAnswer {
  type: 'ended';
  job: number;
}

export type Answer =
  EventsAnswer | HelpAnswer | ReadAnswer | TaskAnswer | ReportAnswer | EndedAnswer;
