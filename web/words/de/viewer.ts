/** What `<foldwright-viewer>` says in German. */
import type { ViewerWords } from '../en/viewer.js';
import { count, figure } from './numbers.js';

export const viewer: ViewerWords = {
  unfold: 'Abwickeln',
  show: 'Modell zeigen',
  cancel: 'Abbrechen',
  play: 'Abspielen',
  pause: 'Anhalten',
  slider: 'Wie weit es gefaltet ist',
  percent: ({ share }) => `${figure(Math.floor(100 * share))} %`,
  flat: 'flach',
  folded: 'gefaltet',
  foldedBy: ({ time }) => `zu ${figure(Math.floor(100 * time))} % gefaltet`,
  downloads: 'Herunterladen',
  model: ({ name, pieces }) =>
    `${name} als Papiermodell aus ${count(pieces, 'Teil', 'Teilen')}. Pfeiltasten drehen es`,
  nets: ({ name, pieces }) =>
    `Netze von ${name}: ${count(pieces, 'Teil', 'Teile')} zum Ausschneiden`,
  sheet: ({ sheet, sheets }) => `Blatt ${figure(sheet)} von ${figure(sheets)}`,
  noPicture: 'Dieser Browser kann das Modell nicht in 3D zeichnen.',
  faults: {
    'no-model': 'Es gibt noch kein Modell zum Abwickeln.',
    'not-loaded': 'Das Modell lässt sich nicht laden.',
    'not-fold':
      'In dieser FOLD-Datei ist kein Modell mit seinen Netzen, wie Foldwright sie schreibt.',
    'not-unfolded': 'Das Modell wurde noch nicht abgewickelt.',
    'not-written':
      'Aus einer FOLD-Datei lässt sich das nicht schreiben: Wickle dafür das Modell ab.',
    removed: 'Der Betrachter ist nicht mehr auf der Seite.',
  },
};
