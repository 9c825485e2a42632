/** How long ago something was. */
import type { Words } from './words.js';

/** Steps of time with their length in seconds, the longest first. */
const steps = [
  ['year', 365 * 86_400],
  ['month', 30 * 86_400],
  ['week', 7 * 86_400],
  ['day', 86_400],
  ['hour', 3600],
  ['minute', 60],
] as const;

/** "just now", "2 hours ago", "yesterday"; both in ms. */
export function agoWords({ keeping }: Words, then: number, now: number): string {
  const seconds = Math.max(0, (now - then) / 1000);
  const step = steps.find(([, length]) => seconds >= length);
  return step ? keeping.ago(Math.floor(seconds / step[1]), step[0]) : keeping.justNow;
}
