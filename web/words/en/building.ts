/** What the cover and the pages with the steps say in English. */
import type { BuildingWords, EdgeList } from '../building.js';
import { all, count, figure } from './numbers.js';

const views = {
  'front-left': 'seen from the front and the left',
  'back-right': 'seen from the back and the right',
  'front-right': 'seen from the front and the right',
  'back-left': 'seen from the back and the left',
  above: 'seen from above',
  below: 'seen from below',
} as const;

const marks = {
  'close-first': 'close: start',
  'close-last': 'close: last edge',
  'glue-first': 'glue on: start',
  'glue-last': 'glue on: last edge',
  valley: 'valley fold',
  border: 'glued to this colour',
} as const;

/** "about 40 minutes", "about 3½ hours": nobody works to the minute. */
function duration({ seconds }: { seconds: number }): string {
  const minutes = seconds / 60;
  if (minutes < 57.5) return `about ${count(Math.max(5, 5 * Math.round(minutes / 5)), 'minute')}`;
  const halves = Math.round(minutes / 30);
  if (halves >= 20) return `about ${figure(Math.round(minutes / 60))} hours`;
  const whole = Math.floor(halves / 2);
  return halves % 2 === 1 ? `about ${figure(whole)}½ hours` : `about ${count(whole, 'hour')}`;
}

function withoutNumber({ edges, unnumbered }: EdgeList): string {
  if (unnumbered === 0) return '';
  if (unnumbered === edges) {
    return edges === 1 ? 'one edge without a number' : `${figure(edges)} edges without a number`;
  }
  return `and ${count(unnumbered, 'edge')} without a number`;
}

function startAndEnd({ edges, first, last }: EdgeList): string {
  if (edges < 2 || first === null) return '.';
  return last === null || last === first
    ? `. Start at ${first}.`
    : `. Start at ${first}; ${last} comes last.`;
}

function close(list: EdgeList): string {
  const runs = [list.runs.join(', '), withoutNumber(list)].filter((text) => text !== '').join(' ');
  return `Close it along ${runs}${startAndEnd(list)}`;
}

function glue(list: Parameters<BuildingWords['glue']>[0]): string {
  const groups = list.groups.map(({ name, runs }) =>
    runs.length > 0 ? `${name} along ${runs.join(', ')}` : name,
  );
  const rest = withoutNumber(list);
  const along = list.unnumbered === list.edges ? ` along ${rest}` : rest && ` ${rest}`;
  return `Glue it to ${groups.join(', then to ')}${along}${startAndEnd(list)}`;
}

function fold({ folds, crease, turn }: Parameters<BuildingWords['fold']>[0]): string {
  if (folds === 0) return 'It has no folds.';
  if (turn === 0) {
    return folds === 1
      ? `Crease its one fold as a ${crease}.`
      : `Crease all its ${figure(folds)} folds as ${crease}s.`;
  }
  const other = crease === 'mountain' ? 'valley' : 'mountain';
  const others = turn === 1 ? `one is a ${other}` : `${figure(turn)} are ${other}s`;
  return `Crease its ${figure(folds)} folds: ${others}, all others are ${crease}s.`;
}

export const building: BuildingWords = {
  pageNote: ({ page, pages }) =>
    `building page ${figure(page)} of ${figure(pages)} · to look at, not to cut`,
  view: ({ name }) => views[name],
  sizeLabel: () => 'Finished size',
  size: ({ width, height, depth }) => `${width} mm wide, ${height} mm high, ${depth} mm deep`,
  amountLabel: () => 'To cut out',
  amount: ({ pieces, sheets, width, height }) =>
    `${count(pieces, 'piece')} on ${count(sheets, 'sheet')} of ${width} × ${height} mm`,
  foldsLabel: () => 'To fold',
  folds: ({ mountains, valleys }) =>
    `${mountains === 0 ? 'no mountain folds' : count(mountains, 'mountain fold')}, ` +
    (valleys === 0 ? 'no valley folds' : count(valleys, 'valley fold')),
  seamsLabel: () => 'To join',
  seams: ({ seams }) => `${count(seams, 'seam')}`,
  gluedLabel: () => 'Time with glue',
  tapedLabel: () => 'Time with tape',
  duration,
  mountain: () => 'mountain fold: like a roof, the printed side is outside',
  valley: () => 'valley fold: like an open book, the printed side is inside',
  valleyPieces: ({ names, pieces, all: isAll }) => {
    if (pieces === 0) return 'All folds are mountains.';
    if (isAll && pieces > 1) return 'All pieces have valley folds: the steps show them in blue.';
    const where = names.length > 0 ? all(names) : `${figure(pieces)} of the pieces`;
    return isAll
      ? 'The steps show the valley folds in blue.'
      : `Valley folds are only on ${where}: the steps show them in blue.`;
  },
  howTitle: () => 'How to build it',
  how: () => [
    'Print the sheets with the pieces at 100 % on thick paper (160 to 200 g/m²). These pages may be thin paper.',
    'Cut along the solid lines. Draw over all folds with an empty pen and a ruler, then fold.',
    'Edges with the same number belong together. Go step by step; let the glue dry before the next step.',
  ],
  piecesTitle: () => 'The pieces and where they go',
  sheet: ({ sheet }) => `on sheet ${figure(sheet)}`,
  faces: ({ faces, flaps }) => `${count(faces, 'face')}, ${count(flaps, 'flap')}`,
  pieceFolds: ({ folds, valleys }) => {
    if (folds === 0) return 'no folds';
    if (valleys === 0) return `${count(folds, 'fold')}, no valley`;
    return valleys === folds
      ? `${count(folds, 'fold')}, all valleys`
      : `${count(folds, 'fold')}, ${figure(valleys)} of them ${valleys === 1 ? 'a valley' : 'valleys'}`;
  },
  hidden: () => 'behind others: drawn as if those were glass',
  strips: ({ runs, strips }) =>
    `Beside the pieces there ${strips === 1 ? 'is a loose strip' : `are ${figure(strips)} loose strips`} of ` +
    `paper, to be glued behind the edges ${runs.join(', ')}.`,
  stepsTitle: () => 'Step by step',
  marks: ({ mark }) => marks[mark],
  stepTitle: ({ step, name }) => `Step ${figure(step)}: piece ${name}`,
  fold,
  close,
  glue,
  apart: () =>
    'No edge of it is glued to the pieces before: put it where the picture shows it. If it has numbers left, ' +
    'look for the same numbers there.',
  finish: ({ last }) =>
    last === null
      ? 'That was the last edge: the model is done.'
      : `${last} is the last edge of all: press it from outside until it holds.`,
};
