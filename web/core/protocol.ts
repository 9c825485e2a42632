/**
 * What the main thread and an engine worker say to each other; types only. A worker runs the jobs
 * that it is given and ends each with exactly one last answer: `cancelled`, or an `event` of type
 * `done` or `error`. Jobs are numbered by whoever asks.
 */
import type { JobEvent, JobOptions } from '../model/job.js';
import type { StageSeconds } from '../model/stage-seconds.js';

/**
 * Starts a job; answered by `event`s. The bytes are copied, so that the asker can run the same file
 * again.
 */
export interface RunRequest {
  type: 'run';
  job: number;
  bytes: Uint8Array;
  /** Its ending tells the format. */
  fileName: string;
  options: JobOptions;
}

/**
 * Ends a job at the next pause of the engine; answered by `cancelled`, or not at all if the job has
 * ended already. Takes as long as the engine's longest step: an asker in a hurry replaces the
 * worker.
 */
export interface CancelRequest {
  type: 'cancel';
  job: number;
}

export type Request = RunRequest | CancelRequest;

/** What a job tells, with the time that only this side of the engine's boundary can measure. */
export type TimedEvent =
  | Exclude<JobEvent, { type: 'stage' | 'done' }>
  /** `seconds` since the job began. */
  | (Extract<JobEvent, { type: 'stage' }> & { seconds: number })
  | (Extract<JobEvent, { type: 'done' }> & { seconds: StageSeconds });

/** Answers `run`, many times; transfers the buffers of all typed arrays in the event. */
export interface EventAnswer {
  type: 'event';
  job: number;
  event: TimedEvent;
}

/** Answers `cancel`; transfers nothing. No event of the job follows. */
export interface CancelledAnswer {
  type: 'cancelled';
  job: number;
}

export type Answer = EventAnswer | CancelledAnswer;
