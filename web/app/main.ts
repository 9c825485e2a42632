import { browserPool } from '../core/browser-pool.js';
import { takeNewestBuild } from './offline.js';
import { Studio } from './studio.js';

/** `?workers=N` in the address: for people who want to keep cores free, or use more of them. */
function workersWanted(): number | undefined {
  const workers = Number(new URLSearchParams(location.search).get('workers'));
  return Number.isInteger(workers) && workers >= 1 && workers <= 64 ? workers : undefined;
}

void takeNewestBuild();
void new Studio(browserPool(workersWanted())).start();
