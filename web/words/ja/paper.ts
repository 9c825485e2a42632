/** Japanese phrases for what is told of sheets before they are printed: what they lack, and what is hard to build. */
import type { Messages, Table } from '../messages.js';
import { figure, percentage, pieces, some } from './numbers.js';

/** Why seams have no flap. */
const misses = {
  narrow: 'すき間が狭すぎる',
  thin: '隣の面が細くて隠せない',
  blocked: '部品のほかの場所がじゃまになる',
  short: '辺が短すぎる',
} as const;

function missingFlaps(params: Messages['missing-flaps']): string {
  const kinds = (Object.keys(misses) as (keyof typeof misses)[]).filter((kind) => params[kind] > 0);
  const reasons = kinds.map((kind) => `${misses[kind]}（${figure(params[kind])}か所）`).join('、');
  const strips =
    params.strips > 0
      ? `そのうち${figure(params.strips)}か所にはつなぎ紙があります。ほかはテープで留めてください`
      : '内側からテープかつなぎ紙で留めてください';
  return (
    `${pieces(params.pieces)}のつなぎ目${figure(params.count)}か所に、のりしろがありません。理由：${reasons}。` +
    `つなぎ目全体の長さの${percentage(params.percent)}です。${strips}`
  );
}

/** Why pictures are not printed, and what helps. */
const pictureFaults = {
  format: 'はPNG、JPEG、GIFの画像ではありません',
  damaged: 'は壊れているか、何も写っていません',
  large: 'は大きすぎます。ピクセル数を減らして保存してください',
} as const;

function picturesUnreadable({ what, files }: Messages['pictures-unreadable']): string {
  return `${some(files)}${pictureFaults[what]}。その面は材質の色になります`;
}

/** So many numbers are looked for one by one; of more it is told where most of them are. */
const mostNumbers = 30;
const mostPlaces = 8;

/** "A：3、12；A-C：1", or "Aに40か所、A-Cに7か所、そのほかに5か所". */
function seamList(seams: readonly string[]): string {
  const numbers = new Map<string, string[]>(); // by the pieces that meet there
  for (const seam of seams) {
    const [names, number] = seam.split(':') as [string, string];
    numbers.set(names, [...(numbers.get(names) ?? []), number]);
  }
  if (seams.length <= mostNumbers) {
    return [...numbers].map(([names, all]) => `${names}：${all.join('、')}`).join('；');
  }
  const most = [...numbers].sort(([, a], [, b]) => b.length - a.length).slice(0, mostPlaces);
  const places = most.map(([names, all]) => `${names}に${figure(all.length)}か所`).join('、');
  const others = most.reduce((rest, [, all]) => rest - all.length, seams.length);
  return others > 0 ? `${places}、そのほかに${figure(others)}か所` : places;
}

function shortSeams({ median_mm, faces, ...size }: Messages['short-seams']): string {
  const words = { height: '高さ', width: '幅', depth: '奥行き' } as const;
  const better = (Object.keys(words) as (keyof typeof words)[]).flatMap((side) => {
    const mm = size[side];
    return mm === undefined
      ? []
      : [`${words[side]}を${figure(mm)} mmにする（--${side} ${figure(mm)}）`];
  });
  if (faces !== undefined) {
    better.push(`面を${figure(faces)}個に減らす（--faces ${figure(faces)}）`);
  }
  const easier = better.length > 0 ? `。作りやすくするには：${better.join('、または')}` : '';
  return `つなぎ目の半分は長さが${figure(median_mm, 1)} mm以下で、貼るのが大変です${easier}`;
}

export const paperMessages = {
  'no-looks': () => 'モデルに、印刷できる色や画像がありません',
  'pictures-unreadable': picturesUnreadable,
  'pictures-not-loaded': () => '画像を読むプログラムを読み込めなかったので、面は材質の色になります',
  'missing-names': ({ pieces: names }) =>
    `${pieces(names)}に名前を書く場所がありません。名前が短いほど場所を取りません`,
  'missing-flaps': missingFlaps,
  'missing-numbers': ({ seams }) =>
    `つなぎ目${figure(seams.length)}か所の両側に、読める番号を書く場所がありません：${seamList(seams)}`,
  'overlapping-pieces': ({ pieces: names }) =>
    `${pieces(names)}は自分自身と重なっていて、そのままでは切り取れません`,
  'short-seams': shortSeams,
  'empty-sheet': ({ sheet, percent, pieces: names }) =>
    `最後のシート（${figure(sheet)}枚目）はほとんど空です。使っているのは${percentage(percent)}です` +
    (names.length > 0 ? `（${pieces(names)}）` : '（つなぎ紙だけ）'),
  'tiny-pieces': ({ pieces: names }) =>
    `${pieces(names)}は10 mmより小さく、なくしやすいので、最後に切り取ってください`,
  'equal-pieces': ({ pieces: names }) =>
    `同じ部品が${figure(names.length)}個必要です：${pieces(names)}`,
} satisfies Partial<Table>;
