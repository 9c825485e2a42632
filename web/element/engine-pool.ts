import { browserPool } from '../core/browser-pool.js';
import type { Pool } from '../core/pool.js';

/** What `lendPool` gives to a studio. */
export interface LentPool {
  /** The workers; those of all studios on the page are the same. */
  pool(): Pool;
  /** Gives them back. When nobody has them any more they are ended. */
  giveBack(): void;
}

let shared: Pool | null = null;
const borrowers = new Set<LentPool>();

/** Lends the page's engine workers to a studio: however many there are, the device has its cores only once. */
export function lendPool(workers: () => number | undefined): LentPool {
  const loan: LentPool = {
    pool() {
      borrowers.add(loan);
      shared ??= browserPool(workers());
      return shared;
    },
    giveBack() {
      borrowers.delete(loan);
      if (borrowers.size > 0) return;
      shared?.close();
      shared = null;
    },
  };
  return loan;
}
