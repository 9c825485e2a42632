/** How the work of a session is watched. */
import type { TimedEvent } from '../core/protocol.js';

export interface WorkOptions {
  /** Ends the work; the promise then rejects with the signal's reason, and all is as it was. */
  signal?: AbortSignal;
  /** Hears everything that a job tells. */
  onEvent?: (event: TimedEvent) => void;
  /** Whether `generation` events show the net under search now and then. */
  pictures?: boolean;
  /** Whether `draft` events tell what could be printed already, once every part has a net. */
  drafts?: boolean;
  /** How long work that is ended by `signal` may take to answer, in ms; 80 unless given. */
  patience?: number;
}

export interface RunWork extends WorkOptions {
  /**
   * Ends a run or an edit as `signal` does, but nets that there are by then become the state, instead of
   * the one before; if there are none, it rejects with the reason of `stop`. Laying them on sheets may
   * take seconds, which `signal` can end.
   */
  stop?: AbortSignal;
}
