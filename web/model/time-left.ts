/** When a run will end, told only while that can be known. */

/** How far a run is, in [0, 1], at a second of its own clock. Neither ever falls. */
export interface Reading {
  second: number;
  progress: number;
}

/** What is known of the end of a run. Begins with `unknownEnd`. */
export interface EndGuess {
  /** The first one, and those of the last seconds. */
  readonly readings: readonly Reading[];
  /** Since when two ways to reckon have agreed; null while they do not. */
  readonly agreedSince: number | null;
  /** The second at which the run will end; null while nobody can tell. */
  readonly end: number | null;
}

export const unknownEnd: EndGuess = { readings: [], agreedSince: null, end: null };

/** Seconds over which the pace of late and the present pace are taken; fewer seconds give none. */
const [longLook, shortLook] = [15, 5];

/** Seconds for which all reckonings agree before anything is told. */
const patience = 4;

/** How many times as long one reckoning may say it takes as another. */
const mostApart = 1.5;

/** By how much a run may turn out to take longer before nothing is told any more: a share, and seconds. */
const [slackShare, slackSeconds] = [0.25, 3];

/** Seconds until the end if all goes on as it did since a reading. */
function secondsLeft(from: Reading, to: Reading): number {
  const pace = (to.progress - from.progress) / (to.second - from.second);
  return (1 - to.progress) / pace;
}

/** Seconds left by the pace of the whole run, of late and at present; null unless all agree. */
function reckon(readings: readonly Reading[], now: Reading): number | null {
  const [first, oldest] = readings;
  const recent = readings.filter(({ second }) => now.second - second >= shortLook).at(-1);
  if (!first || !oldest || !recent) return null;
  const reckoned = [first, oldest, recent].map((from) => secondsLeft(from, now));
  const [less, more] = [Math.min(...reckoned), Math.max(...reckoned)];
  return Number.isFinite(more) && more <= mostApart * less ? more : null;
}

/** An end that is told comes nearer, stays, or is not told any more; it never moves away. */
function settle(told: number, left: number, { second }: Reading): number | null {
  const reckoned = second + left;
  const slack = slackShare * (told - second) + slackSeconds;
  return reckoned > told + slack || told <= second ? null : Math.min(told, reckoned);
}

/**
 * Takes in how far a run is now. An end is told when the pace of the last seconds has been that of the whole run for a
 * while; then it comes nearer or is taken back, until they agree for a while again.
 */
export function withReading(before: EndGuess, now: Reading): EndGuess {
  const [first, ...later] = before.readings;
  const kept = later.filter(({ second }) => now.second - second <= longLook);
  const readings = [...(first ? [first] : []), ...kept, now];
  const left = reckon(readings, now);
  if (left === null) return { readings, agreedSince: null, end: null };
  const agreedSince = before.agreedSince ?? now.second;
  if (before.end !== null) {
    const end = settle(before.end, left, now);
    return { readings, agreedSince: end === null ? null : agreedSince, end };
  }
  const isSteady = now.second - agreedSince >= patience;
  return { readings, agreedSince, end: isSteady ? now.second + left : null };
}
