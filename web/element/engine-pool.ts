import { Shared } from '../browser/shared.js';
import { browserPool } from '../core/browser-pool.js';
import type { Pool } from '../core/pool.js';

/** What `lendPool` gives to a studio. */
export interface LentPool {
  /** The workers; those of all studios on the page are the same. */
  pool(): Pool;
  /** Gives them back. When nobody has them any more they are ended. */
  giveBack(): void;
}

const shared = new Shared<Pool>((pool) => pool.close());

/** Lends the page's engine workers to a studio: however many there are, the device has its cores only once. */
export function lendPool(workers: () => number | undefined): LentPool {
  const loan: LentPool = {
    pool: () => shared.lend(loan, () => browserPool(workers())),
    giveBack: () => shared.giveBack(loan),
  };
  return loan;
}
