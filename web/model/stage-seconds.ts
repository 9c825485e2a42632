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
