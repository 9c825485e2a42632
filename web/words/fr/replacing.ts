/** What is said in French of a model that takes the place of another one. */
import type { Words } from '../words.js';
import { choose, figure, quoted } from './numbers.js';

const heights = ['en bas', '', 'en haut'];
const sides = ['à gauche', '', 'à droite'];
const depths = ['derrière', '', 'devant'];

export const replacing: Words['replacing'] = {
  replaced: 'modèle remplacé',
  noProject: (file) =>
    `${quoted(file)} est un projet avec ses propres changements. Ouvre-le à part, ou choisis un modèle.`,
  headline: (changes) =>
    `${figure(changes)} ${choose(changes, 'changement ne va pas', 'changements ne vont pas')} avec le nouveau modèle`,
  lost: (change, place, why) =>
    `${change[0]!.toUpperCase()}${change.slice(1)}${place === null ? '' : ` (${place})`}\u202f: ${why}.`,
  near: ([x, y, z]) =>
    [heights[y + 1], sides[x + 1], depths[z + 1]].filter((word) => word !== '').join(', ') ||
    'au milieu',
};
