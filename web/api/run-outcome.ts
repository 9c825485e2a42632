/** What a run comes to, also one that was ended. */
import type { TimedResult } from '../core/client.js';
import type { TimedEvent } from '../core/protocol.js';
import { addSeconds } from '../model/stage-seconds.js';
import type { RunWork } from './work.js';

/** What a run comes to; the nets so far of one that was stopped. */
export async function outcome(
  run: (work: RunWork) => Promise<TimedResult>,
  work: RunWork,
): Promise<{ result: TimedResult; isWhole: boolean }> {
  let best: TimedResult | null = null;
  const onEvent = (event: TimedEvent): void => {
    if (event.type === 'cancelled' && event.best) best = { ...event.best, seconds: event.seconds };
    work.onEvent?.(event);
  };
  try {
    return { result: await run({ ...work, onEvent }), isWhole: true };
  } catch (error) {
    if (!best || !work.stop?.aborted || work.signal?.aborted) throw error;
    return { result: best, isWhole: false };
  }
}

/** A result, with what went into the one that it was made of. */
export function together(before: TimedResult, result: TimedResult): TimedResult {
  const { generations, moves } = before.search;
  return {
    ...result,
    search: {
      generations: generations + result.search.generations,
      moves: moves + result.search.moves,
    },
    seconds: addSeconds(before.seconds, result.seconds),
  };
}
