/** What is said in German of a model that takes the place of another one. */
import type { Words } from '../words.js';
import { count } from './numbers.js';

const heights = ['unten', '', 'oben'];
const sides = ['links', '', 'rechts'];
const depths = ['hinten', '', 'vorn'];

export const replacing: Words['replacing'] = {
  replaced: 'Modell ersetzt',
  noProject: (file) =>
    `„${file}“ ist ein Projekt mit eigenen Änderungen. Öffne es für sich, oder wähle ein Modell.`,
  headline: (changes) =>
    `${count(changes, 'Änderung passt', 'Änderungen passen')} nicht zum neuen Modell`,
  lost: (change, place, why) =>
    `${change[0]!.toUpperCase()}${change.slice(1)}${place === null ? '' : ` (${place})`}: ${why}.`,
  near: ([x, y, z]) =>
    [heights[y + 1], sides[x + 1], depths[z + 1]].filter((word) => word !== '').join(', ') ||
    'in der Mitte',
};
