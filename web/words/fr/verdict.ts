/** What a verdict says in French. */
import type { Remedy } from '../../model/remedies.js';
import type { Conclusion, FindingParams } from '../../model/verdict.js';
import type { FindingWords, VerdictWords } from '../verdict.js';
import { building } from './building.js';
import { all, choose, count, figure, ofPieces, percentage, pieces } from './numbers.js';

const points = (number: number): string => count(number, 'point', 'points');
const sheets = (number: number): string => count(number, 'feuille', 'feuilles');

/** A length in mm that is not told more exactly than it can be seen. */
function millimetres(mm: number): string {
  return `${figure(mm, mm < 10 ? 1 : 0)} mm`;
}

function unproved(found: FindingParams['unproved-folding'] & { count: number }): FindingWords {
  const { count: number, unchecked, pieces: names } = found;
  const hint =
    unchecked === number
      ? `Personne n’a cherché comment plier ${pieces(names)}. Avec moins de triangles, c’est plus facile.`
      : `On n’a trouvé aucune façon de plier ${pieces(names)} sans que le papier traverse le papier. Le papier est souple, alors ça marche souvent quand même.`;
  const title = `${count(number, 'pièce est peut-être difficile', 'pièces sont peut-être difficiles')} à plier`;
  return { title, hint };
}

const findings: VerdictWords['findings'] = {
  unfinished: {
    good: () => 'Chaque triangle est dans une pièce',
    bad: ({ count: number }) => ({
      title: `${count(number, 'triangle n’est', 'triangles ne sont')} dans aucune pièce`,
      hint: 'La recherche a été arrêtée trop tôt. Appuie encore sur «\u202fDéplier\u202f» et laisse-la finir.',
    }),
  },
  'run-stopped': {
    good: () => 'La recherche est allée au bout',
    bad: () => ({
      title: 'La recherche a été arrêtée avant la fin',
      hint: 'Ce qui est là peut se construire. Si la recherche va au bout, des patrons plus faciles viendront peut-être.',
    }),
  },
  'overlapping-pieces': {
    good: () => 'Aucune pièce ne se recouvre elle-même',
    bad: ({ count: number, pieces: names }) => ({
      title: count(number, 'pièce se recouvre elle-même', 'pièces se recouvrent elles-mêmes'),
      hint: `Personne ne peut découper ${pieces(names)} en entier.`,
    }),
  },
  'beyond-paper': {
    good: () => 'Chaque pièce tient sur sa feuille',
    bad: ({ count: number, pieces: names }) => ({
      title: count(
        number,
        'pièce ne tient pas sur sa feuille',
        'pièces ne tiennent pas sur leurs feuilles',
      ),
      hint: `L’imprimante couperait un bout ${ofPieces(names)}.`,
    }),
  },
  'short-seams': {
    good: () => 'Les arêtes à coller sont assez longues pour les doigts',
    bad: ({ count: number, median_mm, isRed }) => ({
      title: count(number, 'arête à coller est trop courte', 'arêtes à coller sont trop courtes'),
      hint: `La moitié des arêtes fait ${millimetres(median_mm)} ou moins\u202f: ${
        isRed ? 'trop petit pour n’importe quel doigt.' : 'un bout de doigt a besoin de 12 mm.'
      }`,
    }),
  },
  'missing-flaps': {
    good: () => 'Presque chaque arête a une languette à coller',
    bad: ({ count: number, share }) => ({
      title: `${count(number, 'arête n’a', 'arêtes n’ont')} pas de languette à coller`,
      hint: `C’est ${percentage(Math.round(100 * share))} des arêtes qui en ont besoin. Ferme-${choose(number, 'la', 'les')} de l’intérieur avec de l’adhésif ou des bandes de papier.`,
    }),
  },
  'missing-numbers': {
    good: () => 'On voit quelles arêtes vont ensemble',
    bad: ({ count: number }) => ({
      title: `${count(number, 'arête n’a', 'arêtes n’ont')} pas de numéro lisible`,
      hint: 'Regarde sur le modèle ce qui va ensemble à cet endroit.',
    }),
  },
  'missing-names': {
    good: () => 'Chaque pièce dit laquelle elle est',
    bad: ({ count: number, pieces: names }) => ({
      title: count(
        number,
        'pièce n’a pas de place pour sa lettre',
        'pièces n’ont pas de place pour leur lettre',
      ),
      hint: `Écris-la au dos ${ofPieces(names)} quand tu ${choose(number, 'la', 'les')} découpes.`,
    }),
  },
  'tiny-pieces': {
    good: () => 'Aucune pièce n’est trop petite',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'pièce fait', 'pièces font')} moins de 10 mm`,
      hint: `Découpe ${pieces(names)} en dernier\u202f: de si petites choses se perdent.`,
    }),
  },
  'weak-necks': {
    good: () => 'Aucune pièce ne tient qu’à un fil',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'pièce peut', 'pièces peuvent')} se déchirer à un endroit étroit`,
      hint: `Mets de l’adhésif à cet endroit au dos ${ofPieces(names)} avant de plier.`,
    }),
  },
  'unproved-folding': {
    good: () => 'Chaque pièce peut se plier\u202f: on l’a essayé du plat jusqu’au bout',
    bad: unproved,
  },
  'spare-sheet': {
    good: ({ sheets: number }) =>
      number === 1 ? 'Tout tient sur une feuille' : 'Les feuilles sont bien utilisées',
    bad: ({ sheets: number, percent }) => ({
      title: 'Tu peux économiser du papier',
      hint:
        percent < 15
          ? `La dernière feuille, la numéro ${figure(number)}, n’est utilisée qu’à ${percentage(percent)}.`
          : 'Un peu plus petit, il tient sur moins de feuilles.',
    }),
  },
  'long-building': {
    good: ({ seconds }) => `Il faut ${building.duration({ seconds })} pour le construire`,
    bad: ({ seconds }) => ({
      title: `Il faut ${building.duration({ seconds })} pour le construire`,
      hint: 'Prévois plusieurs jours, ou prends moins de triangles.',
    }),
  },
};

function headline({ code }: Conclusion, rows: number): string {
  switch (code) {
    case 'buildable':
      return 'Prêt à imprimer';
    case 'hard':
      return `Tu peux le construire. Regarde d’abord ${points(rows)}`;
    case 'not-buildable':
      return 'Ne l’imprime pas encore\u202f: personne ne peut le construire comme ça';
  }
}

const shapes = { height: 'haut', width: 'large', depth: 'profondeur' } as const;

function remedy(mend: Remedy): string {
  switch (mend.kind) {
    case 'size': {
      const size = `Passer à ${figure(mend.mm)} mm de ${shapes[mend.side]}`;
      return mend.saves > 0 ? `${size}\u202f: ${sheets(mend.saves)} de moins` : size;
    }
    case 'sheets':
      return `Réduire, pour ${sheets(mend.sheets)}`;
    case 'faces':
      return `Prendre ${figure(mend.faces)} triangles`;
    case 'strips':
      return 'Ajouter des bandes à coller derrière';
    case 'numbers-on-flaps':
      return 'Mettre les numéros sur les languettes';
    case 'again':
      return mend.names.length > 3
        ? `Chercher ${count(mend.names.length, 'pièce', 'pièces')} à nouveau`
        : `Chercher ${all(mend.names)} à nouveau`;
    case 'finish':
      return 'Redéplier jusqu’au bout';
    case 'merge':
      return `Joindre ${mend.names.join(' à ')}`;
  }
}

export const verdict: VerdictWords = {
  findings,
  levels: { green: 'Bien\u202f:', amber: 'À voir\u202f:', red: 'Stop\u202f:' },
  headline,
  good: (number) => `${points(number)} ${choose(number, 'est', 'sont')} en ordre`,
  remedy,
};
