/** What a verdict says in English. */
import type { Remedy } from '../../model/remedies.js';
import type { Conclusion, FindingParams } from '../../model/verdict.js';
import type { FindingWords, VerdictWords } from '../verdict.js';
import { building } from './building.js';
import { all, choose, count, figure, percentage, pieces } from './numbers.js';

/** "1 piece is", "3 pieces are" */
function piecesAre(number: number): string {
  return `${count(number, 'piece')} ${choose(number, 'is', 'are')}`;
}

/** A length in mm that is not told more exactly than it can be seen. */
function millimetres(mm: number): string {
  return `${figure(mm, mm < 10 ? 1 : 0)} mm`;
}

function unproved(found: FindingParams['unproved-folding'] & { count: number }): FindingWords {
  const { count: number, unchecked, pieces: names } = found;
  const isUnchecked = unchecked === number;
  const hint = isUnchecked
    ? `Nobody has looked how to fold ${pieces(names)}. Pieces of fewer triangles are easier.`
    : `No way was found to fold ${pieces(names)} without paper going through paper. Paper bends, so it often works all the same.`;
  return { title: `${count(number, 'piece')} may be hard to fold`, hint };
}

const findings: VerdictWords['findings'] = {
  unfinished: {
    good: () => 'Every triangle is in a piece',
    bad: ({ count: number }) => ({
      title: `${count(number, 'triangle')} ${choose(number, 'is', 'are')} in no piece`,
      hint: 'The search was stopped too early. Press Unfold again and let it finish.',
    }),
  },
  'run-stopped': {
    good: () => 'The search came to its end',
    bad: () => ({
      title: 'The search was stopped before its end',
      hint: 'You can build what is here. Nets that are easier to build may come when the search finishes.',
    }),
  },
  'overlapping-pieces': {
    good: () => 'No piece lies on top of itself',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'piece')} ${choose(number, 'lies', 'lie')} on top of ${choose(number, 'itself', 'themselves')}`,
      hint: `Nobody can cut out ${pieces(names)} whole.`,
    }),
  },
  'beyond-paper': {
    good: () => 'Every piece fits on its sheet',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'piece')} ${choose(number, 'does', 'do')} not fit on ${choose(number, 'its sheet', 'their sheets')}`,
      hint: `The printer would cut off a bit of ${pieces(names)}.`,
    }),
  },
  'short-seams': {
    good: () => 'The edges to glue are long enough for fingers',
    bad: ({ count: number, median_mm, isRed }) => ({
      title: `${count(number, 'edge')} to glue ${choose(number, 'is', 'are')} too short`,
      hint: `Half of all edges are at most ${millimetres(median_mm)} long: ${
        isRed ? 'too small for any fingers.' : 'a fingertip needs 12 mm.'
      }`,
    }),
  },
  'missing-flaps': {
    good: () => 'Nearly every edge has a flap to glue it by',
    bad: ({ count: number, share }) => ({
      title: `${count(number, 'edge')} ${choose(number, 'has', 'have')} no flap to glue ${choose(number, 'it', 'them')} by`,
      hint: `That is ${percentage(Math.round(100 * share))} of the edges that need one. Tape or strips of paper from inside close ${choose(number, 'it', 'them')}.`,
    }),
  },
  'missing-numbers': {
    good: () => 'You can see which edges belong together',
    bad: ({ count: number }) => ({
      title: `${count(number, 'edge')} ${choose(number, 'has', 'have')} no number that can be read`,
      hint: 'Look at the model to see what belongs together there.',
    }),
  },
  'missing-names': {
    good: () => 'Every piece says which one it is',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'piece')} ${choose(number, 'has', 'have')} no room for ${choose(number, 'its letter', 'their letters')}`,
      hint: `Write on the back of ${pieces(names)} when you cut ${choose(number, 'it', 'them')} out.`,
    }),
  },
  'tiny-pieces': {
    good: () => 'No piece is too small',
    bad: ({ count: number, pieces: names }) => ({
      title: `${piecesAre(number)} smaller than 10 mm`,
      hint: `Cut out ${pieces(names)} last: such small things get lost.`,
    }),
  },
  'weak-necks': {
    good: () => 'No piece hangs together by a thread',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'piece')} may tear at a narrow place`,
      hint: `Put tape on the back of ${pieces(names)} there before you fold.`,
    }),
  },
  'unproved-folding': {
    good: () => 'Every piece can be folded: it was tried from flat to finished',
    bad: unproved,
  },
  'spare-sheet': {
    good: ({ sheets }) => (sheets === 1 ? 'All is on one sheet' : 'The sheets are well used'),
    bad: ({ sheets, percent }) => ({
      title: 'You can save paper',
      hint:
        percent < 15
          ? `Only ${percentage(percent)} of the last sheet, number ${figure(sheets)}, is used.`
          : 'A little smaller, it goes on fewer sheets.',
    }),
  },
  'long-building': {
    good: ({ seconds }) => `It takes ${building.duration({ seconds })} to build`,
    bad: ({ seconds }) => ({
      title: `It takes ${building.duration({ seconds })} to build`,
      hint: 'Plan several days, or use fewer triangles.',
    }),
  },
};

/** The verdict in one line; `rows`: how many findings there are to look at. */
function headline({ code }: Conclusion, rows: number): string {
  switch (code) {
    case 'buildable':
      return 'Ready to print';
    case 'hard':
      return `You can build it. Look at ${count(rows, 'thing')} first`;
    case 'not-buildable':
      return 'Do not print it yet: nobody can build it like this';
  }
}

/** How many rows there are at which all is well. */
function good(number: number): string {
  return `${count(number, 'thing')} ${choose(number, 'is', 'are')} fine`;
}

const shapes = { height: 'high', width: 'wide', depth: 'deep' } as const;

/** What a button does that mends something. */
function remedy(remedy: Remedy): string {
  switch (remedy.kind) {
    case 'size': {
      const size = `Make it ${figure(remedy.mm)} mm ${shapes[remedy.side]}`;
      return remedy.saves > 0 ? `${size}: ${count(remedy.saves, 'sheet')} less` : size;
    }
    case 'sheets':
      return `Make it smaller, for ${count(remedy.sheets, 'sheet')}`;
    case 'faces':
      return `Use ${figure(remedy.faces)} triangles`;
    case 'strips':
      return 'Add paper strips to glue behind';
    case 'numbers-on-flaps':
      return 'Put numbers on flaps';
    case 'again':
      return remedy.names.length > 3
        ? `Search ${count(remedy.names.length, 'piece')} again`
        : `Search ${all(remedy.names)} again`;
    case 'finish':
      return 'Unfold again to the end';
    case 'merge':
      return `Join ${remedy.names.join(' to ')}`;
  }
}

export const verdict: VerdictWords = {
  findings,
  levels: { green: 'Good:', amber: 'Look:', red: 'Stop:' },
  headline,
  good,
  remedy,
};
