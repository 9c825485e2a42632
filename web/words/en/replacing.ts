/** What is said in English of a model that takes the place of another one. */
import { count } from './numbers.js';

const heights = ['at the bottom', '', 'at the top'];
const sides = ['on the left', '', 'on the right'];
const depths = ['at the back', '', 'at the front'];

export const replacing = {
  /** To be read after "Undo: ". */
  replaced: 'replacing the model',
  noProject: (file: string): string =>
    `“${file}” is a project with changes of its own. Open it by itself, or choose a model.`,
  headline: (changes: number): string => `${count(changes, 'change')} did not fit the new model`,
  /** `change`: as after "Undo: "; `place`: where it was made, null if that is no place. */
  lost: (change: string, place: string | null, why: string): string =>
    `${change[0]!.toUpperCase()}${change.slice(1)}${place === null ? '' : ` (${place})`}: ${why}.`,
  /** Each number is -1, 0 or 1: from left to right, from the bottom to the top, from the back to the front. */
  near: ([x, y, z]: readonly [number, number, number]): string =>
    [heights[y + 1], sides[x + 1], depths[z + 1]].filter((word) => word !== '').join(', ') ||
    'in the middle',
};
