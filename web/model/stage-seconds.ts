/** Wall-clock seconds that a job spent in each stage; `total` is the whole job. */
export interface StageSeconds {
  read: number;
  learn: number;
  cluster: number;
  search: number;
  /** Looking for folding motions. */
  fold: number;
  /** Making nets better to craft. */
  compact: number;
  paper: number;
  total: number;
}

/** The time of two jobs, one after the other. */
export function addSeconds(one: StageSeconds, other: StageSeconds): StageSeconds {
  return {
    read: one.read + other.read,
    learn: one.learn + other.learn,
    cluster: one.cluster + other.cluster,
    search: one.search + other.search,
    fold: one.fold + other.fold,
    compact: one.compact + other.compact,
    paper: one.paper + other.paper,
    total: one.total + other.total,
  };
}
