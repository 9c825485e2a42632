/** Japanese names of the sample models, by their ids. */
import type { Words } from '../words.js';

export const samples: Words['samples'] = {
  whale: 'クジラ',
  duck: 'アヒル',
  cat: 'ネコ',
  rabbit: 'ウサギ',
  fish: '魚',
  heart: 'ハート',
  knot: '結び目',
  star: '星',
  house: '家',
  torus: 'リング',
  icosahedron: '正二十面体',
  cube: '立方体',
};
