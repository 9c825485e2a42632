/** Short enough that a cancel is seen at once, long enough that pauses cost next to nothing. */
const targetMilliseconds = 10;

// The engine's unit is about a microsecond: between 0.1 ms and 1 s on a machine of today.
const [least, most] = [100, 1_000_000];

/**
 * The budget for the next step, in the engine's units of work, from how long the last one took.
 * Changes by at most a factor of two a step: single steps cannot be shortened and would mislead it.
 * Results do not depend on budgets.
 */
export function nextBudget(budget: number, milliseconds: number): number {
  const wanted = milliseconds > 0 ? (budget * targetMilliseconds) / milliseconds : Infinity;
  const near = Math.min(Math.max(wanted, budget / 2), budget * 2);
  return Math.round(Math.min(Math.max(near, least), most));
}
