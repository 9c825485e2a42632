/** German phrases for what is told of sheets before they are printed: what they lack, and what is hard to build. */
import type { Messages, Table } from '../messages.js';
import { choose, count, figure, percentage, pieces, some } from './numbers.js';

/** Why seams have no flap. */
const misses = {
  narrow: 'in Winkeln, die zu eng dafür sind',
  thin: 'wo die Nachbarfläche zu schmal ist, um eine zu verdecken',
  blocked: 'wo etwas anderes vom Teil im Weg ist',
  short: 'zu kurz dafür',
} as const;

function missingFlaps(params: Messages['missing-flaps']): string {
  const kinds = (Object.keys(misses) as (keyof typeof misses)[]).filter((kind) => params[kind] > 0);
  const reasons = kinds.map((kind) => `${figure(params[kind])} ${misses[kind]}`).join(', ');
  const strips =
    params.strips > 0
      ? `${figure(params.strips)} ${choose(params.strips, 'hat', 'haben')} dafür einen losen Streifen, für andere reicht Klebeband`
      : 'schließe sie von innen mit Klebeband oder Papierstreifen';
  return (
    `keine Lasche an ${count(params.count, 'Naht', 'Nähten')} von ${pieces(params.pieces, 'Teilen')}: ${reasons}. ` +
    `Das sind ${percentage(params.percent)} der Länge aller Nähte; ${strips}`
  );
}

/** Why pictures are not printed, and what helps. */
const pictureFaults = {
  format: ['ist kein Bild in PNG, JPEG oder GIF', 'sind keine Bilder in PNG, JPEG oder GIF'],
  damaged: [
    'ist beschädigt, oder es ist nichts darauf zu sehen',
    'sind beschädigt, oder es ist nichts darauf zu sehen',
  ],
  large: [
    'ist zu groß, speichere es mit weniger Pixeln',
    'sind zu groß, speichere sie mit weniger Pixeln',
  ],
} as const;

function picturesUnreadable({ what, files }: Messages['pictures-unreadable']): string {
  const [one, many] = pictureFaults[what];
  const fault = choose(files.length, one, many);
  return `${some(files)} ${fault}: Die Flächen damit haben die Farbe ihres Materials`;
}

/** So many numbers are looked for one by one; of more it is told where most of them are. */
const mostNumbers = 30;
const mostPlaces = 8;

/** "A: 3, 12; A-C: 1", or "40 auf A, 7 auf A-C und 5 anderswo". */
function seamList(seams: readonly string[]): string {
  const numbers = new Map<string, string[]>(); // by the pieces that meet there
  for (const seam of seams) {
    const [names, number] = seam.split(':') as [string, string];
    numbers.set(names, [...(numbers.get(names) ?? []), number]);
  }
  if (seams.length <= mostNumbers) {
    return [...numbers].map(([names, all]) => `${names}: ${all.join(', ')}`).join('; ');
  }
  const most = [...numbers].sort(([, a], [, b]) => b.length - a.length).slice(0, mostPlaces);
  const places = most.map(([names, all]) => `${figure(all.length)} auf ${names}`).join(', ');
  const others = most.reduce((rest, [, all]) => rest - all.length, seams.length);
  return others > 0 ? `${places} und ${figure(others)} anderswo` : places;
}

function shortSeams({ median_mm, faces, ...size }: Messages['short-seams']): string {
  const words = { height: 'hoch', width: 'breit', depth: 'tief' } as const;
  const better = (Object.keys(words) as (keyof typeof words)[]).flatMap((side) => {
    const mm = size[side];
    return mm === undefined ? [] : [`${figure(mm)} mm ${words[side]} (--${side} ${mm})`];
  });
  if (faces !== undefined) {
    better.push(`auf ${figure(faces)} Flächen vereinfacht (--faces ${faces})`);
  }
  const easier = better.length > 0 ? `; leichter zu bauen: ${better.join(', oder ')}` : '';
  return `die Hälfte der Nähte ist höchstens ${figure(median_mm, 1)} mm lang und schwer zu kleben${easier}`;
}

export const paperMessages = {
  'no-looks': () => 'das Modell hat keine Farben oder Bilder, die sich drucken ließen',
  'pictures-unreadable': picturesUnreadable,
  'pictures-not-loaded': () =>
    'was Bilder liest, ließ sich nicht laden: Flächen haben die Farben ihrer Materialien',
  'missing-names': ({ pieces: names }) =>
    `kein Platz für ${choose(names.length, 'den Namen', 'die Namen')} auf ${pieces(names, 'Teilen')}; kurze Namen brauchen weniger`,
  'missing-flaps': missingFlaps,
  'missing-numbers': ({ seams }) =>
    `kein Platz für eine lesbare Nummer auf beiden Seiten von ${count(seams.length, 'Naht', 'Nähten')}: ${seamList(seams)}`,
  'overlapping-pieces': ({ pieces: names }) =>
    `${pieces(names)} ${choose(names.length, 'überlappt sich selbst und lässt', 'überlappen sich selbst und lassen')} sich nicht ganz ausschneiden`,
  'short-seams': shortSeams,
  'empty-sheet': ({ sheet, percent, pieces: names }) =>
    `das letzte Blatt, Nummer ${figure(sheet)}, ist fast leer: ${percentage(percent)} davon ${percent === 1 ? 'wird' : 'werden'} gebraucht` +
    (names.length > 0 ? `, von ${pieces(names, 'Teilen')}` : ', von losen Streifen'),
  'tiny-pieces': ({ pieces: names }) =>
    `${pieces(names)} ${choose(names.length, 'ist', 'sind')} kleiner als 10 mm und leicht zu verlieren: Schneide ` +
    `${choose(names.length, 'es', 'sie')} zuletzt aus`,
  'equal-pieces': ({ pieces: names }) =>
    `dasselbe Teil wird ${figure(names.length)}-mal gebraucht: ${pieces(names)}`,
} satisfies Partial<Table>;
