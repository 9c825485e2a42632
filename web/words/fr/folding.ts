/** What is said in French of folding and of the steps in which a model is built. */
import type { Words } from '../words.js';
import { all, count, figure } from './numbers.js';

export const folding: Words['folding'] = {
  flat: 'à plat',
  foldedBy: (percent) => `plié à ${figure(percent)}\u202f%`,
  folded: 'plié',
  whole: 'le modèle',
  inPlace: (piece) => `la pièce ${piece} est en place`,
  joining: (piece) => `assemblage de la pièce ${piece}`,
  doubts: (names) =>
    `On ne connaît aucune façon de plier ${names === null ? 'ces pièces' : all(names)}\u202f: ` +
    'l’image fait tourner tous les plis de façon égale, et des faces peuvent se traverser.',
  play: 'Lecture',
  pause: 'Arrêter',
};

const kinds = { mountain: 'montagne', valley: 'vallée' } as const;

export const steps: Words['steps'] = {
  done: (done, of) => `${count(done, 'faite', 'faites')} sur ${figure(of)}`,
  pieceDone: (piece) => `La pièce ${piece} est finie`,
  piece: (piece) => `Pièce ${piece}\u202f:`,
  crease: (p) => {
    if (p.folds === 0) return 'elle n’a pas de plis.';
    const own = kinds[p.crease];
    const other = kinds[p.crease === 'mountain' ? 'valley' : 'mountain'];
    if (p.turn === 0) {
      return p.folds === 1
        ? `marque son seul pli en ${own}.`
        : `marque ses ${figure(p.folds)} plis en ${own}.`;
    }
    const turned = p.turn === 1 ? 'retourne ce pli' : `retourne ces ${figure(p.turn)} plis`;
    return `marque ses ${figure(p.folds)} plis en ${own}, puis ${turned} en ${other}.`;
  },
  close: (seams) =>
    seams === 1
      ? 'Ferme sa couture.'
      : `Ferme ses ${figure(seams)} coutures dans l’ordre de leurs numéros.`,
  glue: (names, edges) => `Colle-la à ${all(names)} le long de ${count(edges, 'arête', 'arêtes')}.`,
};
