/** French phrases for what is told of sheets before they are printed: what they lack, and what is hard to build. */
import type { Messages, Table } from '../messages.js';
import { choose, count, figure, ofPieces, percentage, pieces, some } from './numbers.js';

/** Why seams have no flap. */
const misses = {
  narrow: 'dans des coins trop étroits pour elle',
  thin: 'là où la face voisine est trop mince pour la cacher',
  blocked: 'là où un autre bout de la pièce gêne',
  short: 'trop courtes pour elle',
} as const;

const missesOne: Readonly<Record<keyof typeof misses, string>> = {
  ...misses,
  narrow: 'dans un coin trop étroit pour elle',
  short: 'trop courte pour elle',
};

function missingFlaps(params: Messages['missing-flaps']): string {
  const kinds = (Object.keys(misses) as (keyof typeof misses)[]).filter((kind) => params[kind] > 0);
  const reasons = kinds
    .map((kind) => count(params[kind], missesOne[kind], misses[kind]))
    .join(', ');
  const strips =
    params.strips > 0
      ? `${figure(params.strips)} ${choose(params.strips, 'a une bande séparée', 'ont une bande séparée')} à la place, l’adhésif suffit aux autres`
      : 'ferme-les de l’intérieur avec de l’adhésif ou des bandes de papier';
  return (
    `pas de languette sur ${count(params.count, 'couture', 'coutures')} ${ofPieces(params.pieces)}\u202f: ${reasons}. ` +
    `C’est ${percentage(params.percent)} de la longueur de toutes les coutures\u202f; ${strips}`
  );
}

/** Why pictures are not printed, and what helps. */
const pictureFaults = {
  format: ['n’est pas une image PNG, JPEG ou GIF', 'ne sont pas des images PNG, JPEG ou GIF'],
  damaged: ['est abîmé, ou on n’y voit rien', 'sont abîmés, ou on n’y voit rien'],
  large: [
    'est trop grand, enregistre-le avec moins de pixels',
    'sont trop grands, enregistre-les avec moins de pixels',
  ],
} as const;

function picturesUnreadable({ what, files }: Messages['pictures-unreadable']): string {
  const [one, many] = pictureFaults[what];
  const fault = choose(files.length, one, many);
  const whose = choose(files.length, 'ses faces', 'leurs faces');
  return `${some(files)} ${fault}\u202f: ${whose} ont la couleur de leur matériau`;
}

/** So many numbers are looked for one by one; of more it is told where most of them are. */
const mostNumbers = 30;
const mostPlaces = 8;

/** "A : 3, 12 ; A-C : 1", or "40 sur A, 7 sur A-C et 5 ailleurs". */
function seamList(seams: readonly string[]): string {
  const numbers = new Map<string, string[]>(); // by the pieces that meet there
  for (const seam of seams) {
    const [names, number] = seam.split(':') as [string, string];
    numbers.set(names, [...(numbers.get(names) ?? []), number]);
  }
  if (seams.length <= mostNumbers) {
    return [...numbers].map(([names, all]) => `${names}\u202f: ${all.join(', ')}`).join('\u202f; ');
  }
  const most = [...numbers].sort(([, a], [, b]) => b.length - a.length).slice(0, mostPlaces);
  const places = most.map(([names, all]) => `${figure(all.length)} sur ${names}`).join(', ');
  const others = most.reduce((rest, [, all]) => rest - all.length, seams.length);
  return others > 0 ? `${places} et ${figure(others)} ailleurs` : places;
}

function shortSeams({ median_mm, faces, ...size }: Messages['short-seams']): string {
  const words = { height: 'de haut', width: 'de large', depth: 'de profondeur' } as const;
  const better = (Object.keys(words) as (keyof typeof words)[]).flatMap((side) => {
    const mm = size[side];
    return mm === undefined ? [] : [`${figure(mm)} mm ${words[side]} (--${side} ${mm})`];
  });
  if (faces !== undefined) {
    better.push(`simplifié à ${figure(faces)} faces (--faces ${faces})`);
  }
  const easier =
    better.length > 0 ? `\u202f; plus facile à construire\u202f: ${better.join(', ou ')}` : '';
  return `la moitié des coutures fait ${figure(median_mm, 1)} mm ou moins, ce qui est difficile à coller${easier}`;
}

export const paperMessages = {
  'no-looks': () => 'le modèle n’a ni couleurs ni images à imprimer',
  'pictures-unreadable': picturesUnreadable,
  'pictures-not-loaded': () =>
    'ce qui lit les images n’a pas pu être chargé\u202f: les faces ont les couleurs de leurs matériaux',
  'missing-names': ({ pieces: names }) =>
    `pas de place pour ${choose(names.length, 'son nom', 'leurs noms')} sur ${pieces(names)}\u202f; des noms courts en prennent moins`,
  'missing-flaps': missingFlaps,
  'missing-numbers': ({ seams }) =>
    `pas de place pour un numéro lisible des deux côtés de ${count(seams.length, 'couture', 'coutures')}\u202f: ${seamList(seams)}`,
  'overlapping-pieces': ({ pieces: names }) =>
    `${pieces(names)} ${choose(names.length, 'se recouvre elle-même et ne peut pas être découpée', 'se recouvrent elles-mêmes et ne peuvent pas être découpées')} en entier`,
  'short-seams': shortSeams,
  'empty-sheet': ({ sheet, percent, pieces: names }) =>
    `la dernière feuille, la numéro ${figure(sheet)}, est presque vide\u202f: ${percentage(percent)} est utilisé` +
    (names.length > 0 ? `, par ${pieces(names)}` : ', par des bandes séparées'),
  'tiny-pieces': ({ pieces: names }) =>
    `${pieces(names)} ${choose(names.length, 'fait moins de 10 mm et se perd', 'font moins de 10 mm et se perdent')} facilement\u202f: découpe-` +
    `${choose(names.length, 'la', 'les')} en dernier`,
  'equal-pieces': ({ pieces: names }) =>
    `la même pièce sert ${figure(names.length)} fois\u202f: ${pieces(names)}`,
} satisfies Partial<Table>;
