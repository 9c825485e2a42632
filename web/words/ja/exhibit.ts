/** What is said in Japanese of a file that is shown with the nets that it brings along. */
import type { Words } from '../words.js';
import { all, figure } from './numbers.js';

export const exhibit: Words['exhibit'] = {
  lead: (pieces) =>
    `見るだけの表示です。モデルと${figure(pieces)}個の展開図を、ファイルにあるとおりに見せています。` +
    'ここでは変えたり印刷したりできません。新しく展開すると、新しい展開図とシートができます。',
  nets: (name, pieces) => `${name}のファイルにある展開図：部品${figure(pieces)}個`,
  piece: (name) => `部品${name}`,
  chosen: (names) => `部品${all(names)}が目立つようになっています。`,
};
