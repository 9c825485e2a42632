/** English phrases for what is told of sheets before they are printed: what they lack, and what is hard to build. */
import type { Messages, Table } from '../messages.js';
import { choose, count, figure, percentage, pieces, some } from './numbers.js';

/** Why seams have no flap. */
const misses = {
  narrow: 'in wedges too narrow for one',
  thin: 'where the neighbouring face is too thin to hide one',
  blocked: 'where something else of the piece is in the way',
  short: 'too short for one',
} as const;

function missingFlaps(params: Messages['missing-flaps']): string {
  const kinds = (Object.keys(misses) as (keyof typeof misses)[]).filter((kind) => params[kind] > 0);
  const reasons = kinds.map((kind) => `${figure(params[kind])} ${misses[kind]}`).join(', ');
  const strips =
    params.strips > 0
      ? `${figure(params.strips)} ${choose(params.strips, 'has', 'have')} a loose strip instead, tape does for others`
      : 'close them with tape or strips of paper from inside';
  return (
    `no flap on ${count(params.count, 'seam')} of ${pieces(params.pieces)}: ${reasons}. ` +
    `That is ${percentage(params.percent)} of the length of all seams; ${strips}`
  );
}

/** Why pictures are not printed, and what helps. */
const pictureFaults = {
  format: ['is no PNG, JPEG or GIF picture', 'are no PNG, JPEG or GIF pictures'],
  damaged: [
    'is damaged, or nothing can be seen on it',
    'are damaged, or nothing can be seen on them',
  ],
  large: ['is too large, save it with fewer pixels', 'are too large, save them with fewer pixels'],
} as const;

function picturesUnreadable({ what, files }: Messages['pictures-unreadable']): string {
  const [one, many] = pictureFaults[what];
  const fault = choose(files.length, one, many);
  const whose = choose(files.length, 'its', 'their');
  return `${some(files)} ${fault}: ${whose} faces have the colour of their material`;
}

/** So many numbers are looked for one by one; of more it is told where most of them are. */
const mostNumbers = 30;
const mostPlaces = 8;

/** "A: 3, 12; A-C: 1", or "40 on A, 7 on A-C and 5 elsewhere". */
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
  const places = most.map(([names, all]) => `${figure(all.length)} on ${names}`).join(', ');
  const others = most.reduce((rest, [, all]) => rest - all.length, seams.length);
  return others > 0 ? `${places} and ${figure(others)} elsewhere` : places;
}

function shortSeams({ median_mm, faces, ...size }: Messages['short-seams']): string {
  const words = { height: 'high', width: 'wide', depth: 'deep' } as const;
  const better = (Object.keys(words) as (keyof typeof words)[]).flatMap((side) => {
    const mm = size[side];
    return mm === undefined ? [] : [`${figure(mm)} mm ${words[side]} (--${side} ${figure(mm)})`];
  });
  if (faces !== undefined)
    better.push(`simplified to ${figure(faces)} faces (--faces ${figure(faces)})`);
  const easier = better.length > 0 ? `; easier to build: ${better.join(', or ')}` : '';
  return `half of the seams are at most ${figure(median_mm, 1)} mm long, which is hard to glue${easier}`;
}

export const paperMessages = {
  'no-looks': () => 'the model has no colours or pictures that could be printed',
  'pictures-unreadable': picturesUnreadable,
  'pictures-not-loaded': () =>
    'what reads pictures could not be loaded: faces have the colours of their materials',
  'missing-names': ({ pieces: names }) =>
    `no room for ${choose(names.length, 'its name', 'their names')} on ${pieces(names)}; short names need less`,
  'missing-flaps': missingFlaps,
  'missing-numbers': ({ seams }) =>
    `no room for a readable number at both sides of ${count(seams.length, 'seam')}: ${seamList(seams)}`,
  'overlapping-pieces': ({ pieces: names }) =>
    `${pieces(names)} ${choose(names.length, 'overlaps itself', 'overlap themselves')} and cannot be cut out whole`,
  'short-seams': shortSeams,
  'empty-sheet': ({ sheet, percent, pieces: names }) =>
    `the last sheet, number ${figure(sheet)}, is almost empty: ${percentage(percent)} of it is used` +
    (names.length > 0 ? `, by ${pieces(names)}` : ', by loose strips'),
  'tiny-pieces': ({ pieces: names }) =>
    `${pieces(names)} ${choose(names.length, 'is', 'are')} smaller than 10 mm and easily lost: cut ` +
    `${choose(names.length, 'it', 'them')} out last`,
  'equal-pieces': ({ pieces: names }) =>
    `the same piece is needed ${count(names.length, 'time')}: ${pieces(names)}`,
} satisfies Partial<Table>;
