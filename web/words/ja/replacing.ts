/** What is said in Japanese of a model that takes the place of another one. */
import type { Words } from '../words.js';
import { figure } from './numbers.js';

const heights = ['下', '', '上'];
const sides = ['左', '', '右'];
const depths = ['後ろ', '', '前'];

export const replacing: Words['replacing'] = {
  replaced: 'モデルの差し替え',
  noProject: (file) =>
    `「${file}」は、変更も入ったプロジェクトです。それだけを開くか、モデルを選んでください。`,
  headline: (changes) => `新しいモデルに合わない変更が${figure(changes)}個あります`,
  lost: (change, place, why) => `${change}${place === null ? '' : `（${place}）`}：${why}。`,
  near: ([x, y, z]) =>
    [heights[y + 1], sides[x + 1], depths[z + 1]].filter((word) => word !== '').join('・') ||
    '真ん中',
};
