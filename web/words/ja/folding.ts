/** What is said in Japanese of folding and of the steps in which a model is built. */
import type { Words } from '../words.js';
import { all, figure } from './numbers.js';

const creases = { mountain: '山折り', valley: '谷折り' } as const;

export const folding: Words['folding'] = {
  flat: '平ら',
  foldedBy: (percent) => `${figure(percent)}%折ったところ`,
  folded: '折り終わり',
  whole: 'モデルの完成',
  inPlace: (piece) => `部品${piece}を付けたところ`,
  joining: (piece) => `部品${piece}を付けています`,
  doubts: (names) =>
    `${names === null ? 'これらの部品' : all(names)}の折り方はわかっていません。` +
    'すべての折り目を同じ割合で折って見せるので、面どうしが通り抜けることがあります。',
  play: '再生',
  pause: '一時停止',
};

export const steps: Words['steps'] = {
  done: (done, of) => `${figure(of)}個のうち${figure(done)}個が完了`,
  pieceDone: (piece) => `部品${piece}は完了`,
  piece: (piece) => `部品${piece}：`,
  crease: (p) => {
    if (p.folds === 0) return '折り目はありません。';
    const own = creases[p.crease];
    const other = creases[p.crease === 'mountain' ? 'valley' : 'mountain'];
    if (p.turn === 0) return `${figure(p.folds)}本の折り目を${own}にします。`;
    return `${figure(p.folds)}本の折り目を${own}にし、次にこの${figure(p.turn)}本を${other}に変えます。`;
  },
  close: (seams) =>
    seams === 1 ? 'つなぎ目を閉じます。' : `${figure(seams)}か所のつなぎ目を番号順に閉じます。`,
  glue: (names, edges) => `${all(names)}に、${figure(edges)}本の辺で貼ります。`,
};
