/** What a verdict says in German. */
import type { Remedy } from '../../model/remedies.js';
import type { Conclusion, FindingParams } from '../../model/verdict.js';
import type { FindingWords, VerdictWords } from '../verdict.js';
import { building } from './building.js';
import { all, choose, count, figure, percentage, pieces } from './numbers.js';

const parts = (number: number): string => count(number, 'Teil', 'Teile');
const edges = (number: number): string => count(number, 'Kante', 'Kanten');
const points = (number: number): string => count(number, 'Punkt', 'Punkte');
const sheets = (number: number): string => count(number, 'Blatt', 'Blätter');

/** A length in mm that is not told more exactly than it can be seen. */
function millimetres(mm: number): string {
  return `${figure(mm, mm < 10 ? 1 : 0)} mm`;
}

function unproved(found: FindingParams['unproved-folding'] & { count: number }): FindingWords {
  const { count: number, unchecked, pieces: names } = found;
  const hint =
    unchecked === number
      ? `Niemand hat nachgesehen, wie sich ${pieces(names)} falten ${choose(names.length, 'lässt', 'lassen')}. Mit weniger Dreiecken ist es leichter.`
      : `Kein Weg wurde gefunden, ${pieces(names)} zu falten, ohne dass Papier durch Papier geht. Papier biegt sich, darum klappt es oft trotzdem.`;
  const title = `${parts(number)} ${choose(number, 'ist', 'sind')} vielleicht schwer zu falten`;
  return { title, hint };
}

const findings: VerdictWords['findings'] = {
  unfinished: {
    good: () => 'Jedes Dreieck ist in einem Teil',
    bad: ({ count: number }) => ({
      title: `${count(number, 'Dreieck ist', 'Dreiecke sind')} in keinem Teil`,
      hint: 'Die Suche wurde zu früh angehalten. Drück noch einmal auf „Abwickeln“ und lass sie zu Ende laufen.',
    }),
  },
  'run-stopped': {
    good: () => 'Die Suche lief zu Ende',
    bad: () => ({
      title: 'Die Suche wurde vor ihrem Ende angehalten',
      hint: 'Was hier ist, kannst du bauen. Leichtere Netze kommen vielleicht, wenn die Suche zu Ende läuft.',
    }),
  },
  'overlapping-pieces': {
    good: () => 'Kein Teil liegt auf sich selbst',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'Teil liegt', 'Teile liegen')} auf sich selbst`,
      hint: `Niemand kann ${pieces(names)} ganz ausschneiden.`,
    }),
  },
  'beyond-paper': {
    good: () => 'Jedes Teil passt auf sein Blatt',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'Teil passt nicht auf sein Blatt', 'Teile passen nicht auf ihre Blätter')}`,
      hint: `Der Drucker würde ein Stück von ${pieces(names, 'Teilen')} abschneiden.`,
    }),
  },
  'short-seams': {
    good: () => 'Die Klebekanten sind lang genug für Finger',
    bad: ({ count: number, median_mm, isRed }) => ({
      title: `${count(number, 'Klebekante ist', 'Klebekanten sind')} zu kurz`,
      hint: `Die Hälfte aller Kanten ist höchstens ${millimetres(median_mm)} lang: ${
        isRed ? 'zu klein für alle Finger.' : 'Eine Fingerspitze braucht 12 mm.'
      }`,
    }),
  },
  'missing-flaps': {
    good: () => 'Fast jede Kante hat eine Klebelasche',
    bad: ({ count: number, share }) => ({
      title: `${edges(number)} ${choose(number, 'hat', 'haben')} keine Klebelasche`,
      hint: `Das sind ${percentage(Math.round(100 * share))} der Kanten, die eine brauchen. Klebeband oder Papierstreifen von innen schließen ${choose(number, 'sie', 'sie')}.`,
    }),
  },
  'missing-numbers': {
    good: () => 'Du siehst, welche Kanten zusammengehören',
    bad: ({ count: number }) => ({
      title: `${edges(number)} ${choose(number, 'hat', 'haben')} keine lesbare Nummer`,
      hint: 'Sieh dort am Modell nach, was zusammengehört.',
    }),
  },
  'missing-names': {
    good: () => 'Jedes Teil sagt, welches es ist',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'Teil hat keinen Platz für seinen', 'Teile haben keinen Platz für ihren')} Buchstaben`,
      hint: `Schreib hinten auf ${pieces(names)}, wenn du ${choose(number, 'es', 'sie')} ausschneidest.`,
    }),
  },
  'tiny-pieces': {
    good: () => 'Kein Teil ist zu klein',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'Teil ist', 'Teile sind')} kleiner als 10 mm`,
      hint: `Schneide ${pieces(names)} zuletzt aus: So kleine Dinge gehen verloren.`,
    }),
  },
  'weak-necks': {
    good: () => 'Kein Teil hängt an einem Faden',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'Teil kann', 'Teile können')} an einer schmalen Stelle reißen`,
      hint: `Kleb dort Klebeband hinten auf ${pieces(names)}, bevor du faltest.`,
    }),
  },
  'unproved-folding': {
    good: () => 'Jedes Teil lässt sich falten: Das ist von flach bis fertig probiert',
    bad: unproved,
  },
  'spare-sheet': {
    good: ({ sheets: number }) =>
      number === 1 ? 'Alles ist auf einem Blatt' : 'Die Blätter sind gut genutzt',
    bad: ({ sheets: number, percent }) => ({
      title: 'Du kannst Papier sparen',
      hint:
        percent < 15
          ? `Vom letzten Blatt, Nummer ${figure(number)}, ${percent < 2 ? 'wird' : 'werden'} nur ${percentage(percent)} gebraucht.`
          : 'Ein wenig kleiner geht es auf weniger Blätter.',
    }),
  },
  'long-building': {
    good: ({ seconds }) => `Das Bauen dauert ${building.duration({ seconds })}`,
    bad: ({ seconds }) => ({
      title: `Das Bauen dauert ${building.duration({ seconds })}`,
      hint: 'Plane mehrere Tage ein, oder nimm weniger Dreiecke.',
    }),
  },
};

function headline({ code }: Conclusion, rows: number): string {
  switch (code) {
    case 'buildable':
      return 'Bereit zum Drucken';
    case 'hard':
      return `Du kannst es bauen. Sieh dir zuerst ${points(rows)} an`;
    case 'not-buildable':
      return 'Druck es noch nicht: So kann es niemand bauen';
  }
}

const shapes = { height: 'hoch', width: 'breit', depth: 'tief' } as const;

function remedy(mend: Remedy): string {
  switch (mend.kind) {
    case 'size': {
      const size = `${figure(mend.mm)} mm ${shapes[mend.side]} machen`;
      return mend.saves > 0 ? `${size}: ${sheets(mend.saves)} weniger` : size;
    }
    case 'sheets':
      return `Kleiner machen, für ${sheets(mend.sheets)}`;
    case 'faces':
      return `${figure(mend.faces)} Dreiecke nehmen`;
    case 'strips':
      return 'Papierstreifen zum Hinterkleben dazu';
    case 'numbers-on-flaps':
      return 'Nummern auf Laschen setzen';
    case 'again':
      return mend.names.length > 3
        ? `${parts(mend.names.length)} neu suchen`
        : `${all(mend.names)} neu suchen`;
    case 'finish':
      return 'Neu abwickeln, bis zum Ende';
    case 'merge':
      return `${mend.names.join(' mit ')} verbinden`;
  }
}

export const verdict: VerdictWords = {
  findings,
  levels: { green: 'Gut:', amber: 'Prüfen:', red: 'Halt:' },
  headline,
  good: (number) => `${points(number)} ${choose(number, 'ist', 'sind')} in Ordnung`,
  remedy,
};
