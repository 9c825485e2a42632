/** What a batch says in German, on its page and in a terminal. */
import type { Words } from '../words.js';
import { building } from './building.js';
import { count, figure } from './numbers.js';

export const batch: Words['batch'] = {
  help: {
    about:
      'Faltet viele Modelle ab. Wird es beendet und wieder gestartet, macht es dort weiter, wo es war; was sich seitdem geändert hat, wird neu gemacht.',
    usage: '[Optionen] <Quelle...>',
    source:
      'Ordner mit Modellen, auch in Unterordnern; oder eine Textdatei mit einem Pfad in jeder Zeile; oder - für so eine Liste auf der Standardeingabe; oder Modelle',
    out: 'Ordner für alles, was geschrieben wird, und eine Seite, die es zeigt',
    format: (names) => `einige von ${names}, mit Kommas dazwischen`,
    shard: 'nur dieser Anteil der Modelle, von 1/N bis N/N: einer für jeden von N Rechnern',
    workers:
      'Bei vielen Modellen ist --workers die Zahl der Modelle zur gleichen Zeit; auto: eins pro Kern.',
  },
  noFolder: (option) => `Option '${option}' ist kein Ordner`,
  noModels:
    'es gibt kein Modell: keine Datei mit OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO oder ZIP und kein Projekt',
  about: (name, text) => `${name}: ${text}`,
  models: (models) => count(models, 'Modell', 'Modelle'),
  outcomes: {
    done: (models) => `${figure(models)} fertig`,
    skipped: (models) => `${figure(models)} schon fertig`,
    refused: (models) => `${figure(models)} unbrauchbar`,
    failed: (models) => `${figure(models)} misslungen`,
    left: (models) => `${figure(models)} noch nicht gemacht`,
  },
  died: (reason) => `das Programm konnte mit diesem Modell nicht weitermachen: ${reason}`,
  ended: (status) => `der Thread endete mit Status ${figure(status)}`,
  goOn: 'derselbe Befehl macht hier weiter',

  pageTitle: 'Papiermodelle',
  amount: ({ pieces, sheets }) =>
    `${count(pieces, 'Teil', 'Teile')} auf ${count(sheets, 'Blatt', 'Blätter')}`,
  building: (seconds) => `${building.duration({ seconds })} zu bauen`,
  picture: (name) => `${name}, gefaltet`,
  notices: (notices) => count(notices, 'Hinweis', 'Hinweise'),
  faults: 'Daraus wurde kein Papiermodell',
  missing: 'noch nicht gemacht',
  failed: 'hier ist das Programm gescheitert; beim nächsten Mal versucht es das noch einmal',
};
