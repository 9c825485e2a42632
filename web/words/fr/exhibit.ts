/** What is said in French of a file that is shown with the nets that it brings along. */
import type { Words } from '../words.js';
import { all, choose, figure } from './numbers.js';

export const exhibit: Words['exhibit'] = {
  lead: (pieces) =>
    `Ceci est seulement pour regarder\u202f: le modèle et ${choose(pieces, 'son patron', `ses ${figure(pieces)} patrons`)} sont montrés comme dans le fichier, ` +
    'et ne peuvent être ni modifiés ni imprimés ici. Déplié à nouveau, le modèle reçoit de nouveaux patrons et de nouvelles feuilles.',
  nets: (name, pieces) =>
    `Patrons de ${name} comme dans le fichier\u202f: ${figure(pieces)} ${choose(pieces, 'pièce', 'pièces')}`,
  piece: (name) => `Pièce ${name}`,
  chosen: (names) =>
    `${choose(names.length, 'La pièce', 'Les pièces')} ${all(names)} ${choose(names.length, 'ressort', 'ressortent')}.`,
};
