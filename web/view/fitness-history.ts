import type { JobEvent } from '../model/job.js';

export interface FitnessPoint {
  generation: number;
  /** At most 0, which is a net without overlaps. */
  best: number;
}

/** More points than a chart has pixels show nothing new. */
const mostPoints = 600;

/** Best fitness of every part over the generations of one run. */
export class FitnessHistory {
  /** By part, in the order of their first generations. */
  readonly parts = new Map<number, FitnessPoint[]>();
  /** The part that was heard of last. */
  current = -1;

  add({ part, generation, best }: Extract<JobEvent, { type: 'generation' }>): void {
    const points = this.parts.get(part) ?? [];
    const last = points.at(-1);
    // A restarted search counts anew; its curve goes on where the one before it ended.
    const after = last && generation < last.generation ? last.generation + 1 : generation;
    points.push({ generation: after, best });
    if (points.length > mostPoints) this.thin(points);
    this.parts.set(part, points);
    this.current = part;
  }

  /** Drops every second point but keeps both ends. */
  private thin(points: FitnessPoint[]): void {
    const kept = points.filter((_point, index) => index % 2 === 0 || index === points.length - 1);
    points.splice(0, points.length, ...kept);
  }
}
