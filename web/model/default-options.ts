import type { JobOptions } from './job-options.js';

/** Millimetres; how high flaps may be. */
export const flapHeights = { least: 1, most: 50 } as const;

/** What a job does when nothing is asked for: the defaults of the command line and of the studio. */
export const defaultOptions: Readonly<JobOptions> = {
  parts: 0,
  heuristic: 'steepest',
  segment: 'merge',
  solver: 'tree',
  folding: 'prefer',
  clearance: 0.01,
  runs: 400,
  // Proxies of 500 to 1000 faces segment as well as anything larger.
  proxy: 1000,
  seed: 1,
  faces: 0,
  up: 'guess',
  repairOff: [],
  fillHoles: 0,
  dropInner: false,
  unite: false,
  sizing: 'fit',
  size: 0,
  unit: 'guess',
  flapSide: 'one',
  flapHeight: 5,
  flapAngle: 60,
  flapStyle: 'run',
  flapBorders: false,
  flapEdges: [],
  locks: [],
  glueStrips: 'none',
  ids: 'flap',
  names: [],
  pins: [],
  compaction: true,
  paperWidth: 210,
  paperHeight: 297,
  orientation: 'auto',
  margin: 10,
  minPiece: 0,
};
