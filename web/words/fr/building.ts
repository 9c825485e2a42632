/**
 * What the cover and the pages with the steps say in French: with no-break spaces that are not narrow, as printed
 * letters need no fonts of their own then.
 */
import type { BuildingWords, EdgeList } from '../building.js';
import { all, count, figure } from './numbers.js';

const views = {
  'front-left': 'vu de devant et de gauche',
  'back-right': 'vu de derrière et de droite',
  'front-right': 'vu de devant et de droite',
  'back-left': 'vu de derrière et de gauche',
  above: 'vu d’en haut',
  below: 'vu d’en bas',
} as const;

const marks = {
  'close-first': 'fermer\u00a0: début',
  'close-last': 'fermer\u00a0: dernière arête',
  'glue-first': 'coller\u00a0: début',
  'glue-last': 'coller\u00a0: dernière arête',
  valley: 'pli vallée',
  border: 'se colle à cette couleur',
} as const;

const kinds = { mountain: 'montagne', valley: 'vallée' } as const;

const mountainFolds = (number: number): string =>
  number === 0 ? 'aucun pli montagne' : count(number, 'pli montagne', 'plis montagne');
const valleyFolds = (number: number): string =>
  number === 0 ? 'aucun pli vallée' : count(number, 'pli vallée', 'plis vallée');

/** "environ 40 minutes", "environ 3 h 30": nobody works to the minute. */
function duration({ seconds }: { seconds: number }): string {
  const minutes = seconds / 60;
  if (minutes < 57.5) return `environ ${figure(Math.max(5, 5 * Math.round(minutes / 5)))} minutes`;
  const halves = Math.round(minutes / 30);
  if (halves >= 20) return `environ ${figure(Math.round(minutes / 60))} heures`;
  const whole = Math.floor(halves / 2);
  return halves % 2 === 1
    ? `environ ${figure(whole)} h 30`
    : `environ ${count(whole, 'heure', 'heures')}`;
}

function withoutNumber({ edges, unnumbered }: EdgeList): string {
  if (unnumbered === 0) return '';
  if (unnumbered === edges) {
    return edges === 1 ? 'une arête sans numéro' : `${figure(edges)} arêtes sans numéro`;
  }
  return `et ${count(unnumbered, 'arête', 'arêtes')} sans numéro`;
}

function startAndEnd({ edges, first, last }: EdgeList): string {
  if (edges < 2 || first === null) return '.';
  return last === null || last === first
    ? `. Commence par ${first}.`
    : `. Commence par ${first}\u00a0; ${last} vient en dernier.`;
}

/** "le long de 12, 13", "le long d’une arête sans numéro" */
function along(edges: string): string {
  return `le long ${edges.startsWith('une ') ? 'd’' : 'de '}${edges}`;
}

function close(list: EdgeList): string {
  const runs = [list.runs.join(', '), withoutNumber(list)].filter((text) => text !== '').join(' ');
  return `Ferme-la ${along(runs)}${startAndEnd(list)}`;
}

function glue(list: Parameters<BuildingWords['glue']>[0]): string {
  const groups = list.groups.map(({ name, runs }) =>
    runs.length > 0 ? `${name} ${along(runs.join(', '))}` : name,
  );
  const rest = withoutNumber(list);
  const others = list.unnumbered === list.edges ? along(rest) : rest;
  return `Colle-la à ${groups.join(', puis à ')}${others && ` ${others}`}${startAndEnd(list)}`;
}

function fold({ folds, crease, turn }: Parameters<BuildingWords['fold']>[0]): string {
  if (folds === 0) return 'Elle n’a pas de plis.';
  const own = kinds[crease];
  if (turn === 0) {
    return folds === 1
      ? `Marque son seul pli en ${own}.`
      : `Marque ses ${figure(folds)} plis, tous en ${own}.`;
  }
  const other = kinds[crease === 'mountain' ? 'valley' : 'mountain'];
  const others = turn === 1 ? `un en ${other}` : `${figure(turn)} en ${other}`;
  return `Marque ses ${figure(folds)} plis\u00a0: ${others}, tous les autres en ${own}.`;
}

export const building: BuildingWords = {
  pageNote: ({ page, pages }) =>
    `page de montage ${figure(page)} sur ${figure(pages)} · à regarder, pas à découper`,
  view: ({ name }) => views[name],
  sizeLabel: () => 'Taille finie',
  size: ({ width, height, depth }) =>
    `${width} mm de large, ${height} mm de haut, ${depth} mm de profondeur`,
  amountLabel: () => 'À découper',
  amount: ({ pieces, sheets, width, height }) =>
    `${count(pieces, 'pièce', 'pièces')} sur ${count(sheets, 'feuille', 'feuilles')} de ${width} × ${height} mm`,
  foldsLabel: () => 'À plier',
  folds: ({ mountains, valleys }) => `${mountainFolds(mountains)}, ${valleyFolds(valleys)}`,
  seamsLabel: () => 'À assembler',
  seams: ({ seams }) => count(seams, 'couture', 'coutures'),
  gluedLabel: () => 'Temps avec colle',
  tapedLabel: () => 'Temps avec adhésif',
  duration,
  mountain: () => 'pli montagne\u00a0: comme un toit, le côté imprimé est à l’extérieur',
  valley: () => 'pli vallée\u00a0: comme un livre ouvert, le côté imprimé est à l’intérieur',
  valleyPieces: ({ names, pieces, all: isAll }) => {
    if (pieces === 0) return 'Tous les plis sont des plis montagne.';
    if (isAll && pieces > 1) {
      return 'Toutes les pièces ont des plis vallée\u00a0: les étapes les montrent en bleu.';
    }
    if (isAll) return 'Les étapes montrent les plis vallée en bleu.';
    const where = names.length > 0 ? all(names) : `${figure(pieces)} des pièces`;
    return `Il n’y a de plis vallée que sur ${where}\u00a0: les étapes les montrent en bleu.`;
  },
  howTitle: () => 'Comment le construire',
  how: () => [
    'Imprime les feuilles avec les pièces à 100\u00a0% sur du papier épais (160 à 200 g/m²). Pour ces pages-ci, du papier fin suffit.',
    'Découpe le long des traits continus. Repasse tous les plis avec un stylo vide et une règle, puis plie.',
    'Les arêtes qui ont le même numéro vont ensemble. Avance étape par étape\u00a0; laisse sécher la colle avant l’étape suivante.',
  ],
  piecesTitle: () => 'Les pièces et leur place',
  sheet: ({ sheet }) => `sur la feuille ${figure(sheet)}`,
  faces: ({ faces, flaps }) =>
    `${count(faces, 'face', 'faces')}, ${count(flaps, 'languette', 'languettes')}`,
  pieceFolds: ({ folds, valleys }) => {
    if (folds === 0) return 'aucun pli';
    const told = count(folds, 'pli', 'plis');
    if (valleys === 0) return `${told}, aucun en vallée`;
    if (valleys === folds) return folds === 1 ? `${told}, en vallée` : `${told}, tous en vallée`;
    return `${told}, dont ${figure(valleys)} en vallée`;
  },
  hidden: () => 'derrière d’autres\u00a0: dessinée comme si celles-ci étaient en verre',
  strips: ({ runs, strips }) =>
    `À côté des pièces, il y a ${strips === 1 ? 'une bande' : `${figure(strips)} bandes`} de ` +
    `papier à coller derrière ${strips === 1 ? 'l’arête' : 'les arêtes'} ${runs.join(', ')}.`,
  stepsTitle: () => 'Étape par étape',
  marks: ({ mark }) => marks[mark],
  stepTitle: ({ step, name }) => `Étape ${figure(step)}\u00a0: pièce ${name}`,
  fold,
  close,
  glue,
  apart: () =>
    'Aucune de ses arêtes ne se colle aux pièces d’avant\u00a0: place-la là où l’image la montre. S’il lui reste des numéros, ' +
    'cherche les mêmes à cet endroit.',
  finish: ({ last }) =>
    last === null
      ? 'C’était la dernière arête\u00a0: le modèle est fini.'
      : `${last} est la toute dernière arête\u00a0: appuie dessus de l’extérieur jusqu’à ce qu’elle tienne.`,
};
