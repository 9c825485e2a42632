/** What is said in Spanish of a model that takes the place of another one. */
import type { Words } from '../words.js';
import { choose, figure } from './numbers.js';

const heights = ['abajo', '', 'arriba'];
const sides = ['a la izquierda', '', 'a la derecha'];
const depths = ['detrás', '', 'delante'];

export const replacing: Words['replacing'] = {
  replaced: 'modelo sustituido',
  noProject: (file) =>
    `«${file}» es un proyecto con sus propios cambios. Ábrelo aparte o elige un modelo.`,
  headline: (changes) =>
    `${figure(changes)} ${choose(changes, 'cambio no encaja', 'cambios no encajan')} en el modelo nuevo`,
  lost: (change, place, why) =>
    `${change[0]!.toUpperCase()}${change.slice(1)}${place === null ? '' : ` (${place})`}: ${why}.`,
  near: ([x, y, z]) =>
    [heights[y + 1], sides[x + 1], depths[z + 1]].filter((word) => word !== '').join(', ') ||
    'en el centro',
};
