/** How the work of a session is watched. */
import type { TimedEvent } from '../core/protocol.js';

export interface WorkOptions {
  /** Ends the work; the promise then rejects with the signal's reason, and all is as it was. */
  signal?: AbortSignal;
  /** Hears everything that a job tells. */
  onEvent?: (event: TimedEvent) => void;
  /** Whether `generation` events show the net under search now and then. */
  pictures?: boolean;
  /** How long work that is ended may take to hand over what it has, in ms; 80 unless given. */
  patience?: number;
}

export interface RunWork extends WorkOptions {
  /**
   * Whether nets that were found before `signal` ended a run become the state, instead of the one
   * before; if there are none, the run rejects as ever.
   */
  keepBest?: boolean;
}
