/** What the studio says in German of the work that a browser keeps. */
import type { Words } from '../words.js';
import { figure } from './numbers.js';

const quoted = (name: string): string => `„${name}“`;

const relative = new Intl.RelativeTimeFormat('de', { numeric: 'auto' });

export const keeping: Words['keeping'] = {
  goOn: (name, isPending) =>
    isPending ? `${quoted(name)} noch einmal abwickeln` : `Weiter mit ${quoted(name)}`,
  ago: (number, unit) => relative.format(-number, unit),
  justNow: 'gerade eben',
  showAll: (number) => `Alle ${figure(number)} zeigen`,
  rename: 'Umbenennen',
  copy: 'Kopieren',
  remove: 'Löschen',
  about: (word, name) => `${quoted(name)}: ${word}`,
  newName: (name) => `Neuer Name von ${quoted(name)}`,
  kept: 'Wird in diesem Browser aufbewahrt. Um es auch anderswo zu haben, lade das Projekt herunter.',
  none: 'Dieser Browser bewahrt für diese Seite nichts auf. Lade das Projekt herunter, bevor du gehst.',
  scarce:
    'Auf diesem Gerät ist nur noch wenig Platz. Lösche alte Arbeiten, oder lade das Projekt herunter, bevor du gehst.',
  unfinished: 'nicht fertig',
  deleted: (name) => `${quoted(name)} wurde gelöscht.`,
  copyOf: (name) => `Kopie von ${name}`,
  full: [
    'Deine letzten Änderungen sind nicht gesichert',
    'Auf diesem Gerät ist kein Platz mehr. Lösche alte Arbeiten auf der Startseite, oder lade das Projekt herunter, damit nichts verloren geht.',
  ],
  lost: [
    'Deine Arbeit ist nicht gesichert',
    'Dieser Browser bewahrt für diese Seite nichts auf. Lade das Projekt herunter, bevor du gehst, damit nichts verloren geht.',
  ],
  copied: (name) => [
    'Diese Arbeit wurde auch auf einer anderen Seite geändert',
    `Beide bleiben: Was du hier siehst, geht weiter als ${quoted(name)}.`,
  ],
  deletedElsewhere: (name) => [
    `${quoted(name)} wurde auf einer anderen Seite gelöscht`,
    'Was du hier siehst, wird nicht mehr aufgehoben. Behalte es, damit nichts verloren geht.',
  ],
  keepIt: 'Behalten',
  gone: (name) => `${quoted(name)} ist nicht mehr da.`,
};
