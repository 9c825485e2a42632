/** What `<foldwright-viewer>` says in English: without the other tables, so that it stays small. */
import { count, figure } from './numbers.js';

/** Why a viewer shows nothing new. */
export type ViewerFault =
  'no-model' | 'not-loaded' | 'not-fold' | 'not-unfolded' | 'not-written' | 'removed';

export const viewer = {
  unfold: 'Unfold',
  show: 'Show the model',
  cancel: 'Cancel',
  play: 'Play',
  pause: 'Pause',
  slider: 'How far it is folded',
  percent: (p: { share: number }): string => `${figure(Math.floor(100 * p.share))} %`,
  flat: 'flat',
  folded: 'folded',
  foldedBy: (p: { time: number }): string => `${figure(Math.floor(100 * p.time))} % folded`,
  downloads: 'Download',
  model: (p: { name: string; pieces: number }): string =>
    `${p.name} as a paper model of ${count(p.pieces, 'piece')}. Arrow keys turn it`,
  nets: (p: { name: string; pieces: number }): string =>
    `Nets of ${p.name}: ${count(p.pieces, 'piece')} to cut out`,
  sheet: (p: { sheet: number; sheets: number }): string =>
    `Sheet ${figure(p.sheet)} of ${figure(p.sheets)}`,
  noPicture: 'This browser cannot draw the model in 3D.',
  faults: {
    'no-model': 'There is no model to unfold yet.',
    'not-loaded': 'The model cannot be loaded.',
    'not-fold': 'This FOLD file does not hold a model with its nets as Foldwright writes them.',
    'not-unfolded': 'The model was not unfolded yet.',
    'not-written': 'This cannot be written from a FOLD file: unfold the model for it.',
    removed: 'The viewer was taken out of the page.',
  } satisfies Record<ViewerFault, string>,
};

/** All that a viewer says by itself, in one language. The English ones are the pattern. */
export type ViewerWords = typeof viewer;
