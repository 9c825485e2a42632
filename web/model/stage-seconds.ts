import { byStage, type Stage } from './stages.js';

/**
 * Wall-clock seconds that a job spent in each stage. `fold` are those, within `search` and `compact`, in which nets
 * that lie flat without overlaps were made to fold, or their motions planned; where several workers are at it, the mean
 * of them. `total` is the whole job.
 */
export type StageSeconds = Record<Stage | 'fold' | 'total', number>;

/** The time of two jobs, one after the other. */
export function addSeconds(one: StageSeconds, other: StageSeconds): StageSeconds {
  return {
    ...byStage((stage) => one[stage] + other[stage]),
    fold: one.fold + other.fold,
    total: one.total + other.total,
  };
}
