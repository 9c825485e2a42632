/** What goes into a session, and how its work is watched. */
import type { TimedEvent } from '../core/protocol.js';

/** A file as it was read. */
export interface ModelFile {
  /** Its ending tells the format where the bytes do not. */
  name: string;
  bytes: Uint8Array;
}

export interface WorkOptions {
  /** Ends the work; the promise then rejects with the signal's reason, and all is as it was. */
  signal?: AbortSignal;
  /** Hears everything that a job tells. */
  onEvent?: (event: TimedEvent) => void;
}
