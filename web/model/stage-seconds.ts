import { stages, type Stage } from './stages.js';

/**
 * Wall-clock seconds that a job spent in each stage; `fold` are those of looking for motions, which is part
 * of the search, and so 0; `total` is the whole job.
 */
export type StageSeconds = Record<Stage | 'fold' | 'total', number>;

/** Seconds for each stage, from what makes them, and for the whole job. */
export function stageSeconds(of: (stage: Stage) => number, total: number): StageSeconds {
  const entries = stages.map((stage) => [stage, of(stage)]);
  return { ...(Object.fromEntries(entries) as Record<Stage, number>), fold: 0, total };
}

/** The time of two jobs, one after the other. */
export function addSeconds(one: StageSeconds, other: StageSeconds): StageSeconds {
  return stageSeconds((stage) => one[stage] + other[stage], one.total + other.total);
}
