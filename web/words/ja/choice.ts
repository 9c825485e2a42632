/** What is said in Japanese of a model that is chosen and looked at before it is unfolded. */
import type { Words } from '../words.js';
import { figure, large, rounded, some } from './numbers.js';
import { excess } from './readers.js';

export const choice: Words['choice'] = {
  opening: (files) => `開いています：${some(files)}`,
  chosen: (files) => `選んだもの：${some(files)}`,
  fileTooLarge: (file, fault) =>
    `「${file}」は大きすぎます。${excess(fault)}。面を減らすか、バイナリ形式で保存してください。`,
  tooMuch: (fault) =>
    `多すぎます。${excess(fault)}。モデルと、それに必要なものだけを選んでください。`,
  notLoaded: (file) => `「${file}」を読み込めません。`,
  notLetIn: (file) =>
    `「${file}」を読み込めません。ほかのサイトにあるファイルは、両方のサイトが許可しているときだけ読み込めます。ファイルを端末に保存して、ここにドロップしてください。`,
  unreadable: (file) =>
    `「${file}」を読めません。フォルダーであるか、移動されたか、開くことが許可されていません。`,
  unreadableDrop: (file) => `「${file}」を読めません。移動されたか、開くことが許可されていません。`,
  noFile:
    'それはファイルではありません。GLB、OBJ、STL、3MF、PLY、OFF、PDO、FOLDのファイルか、それが入ったZIPを選んでください。',
  empty: (file) => `「${file}」は空です。展開するものがありません。`,
  noSamples: 'サンプルを読み込めません。自分のモデルはそのまま使えます。',
  sample: (name, faces) => `${name}（面${figure(faces)}個）`,
  effort: (level, pieces) =>
    `${{ easy: 'かんたん', medium: 'ふつう', hard: 'むずかしい' }[level]}：部品${figure(pieces)}個`,
  pending: (names) => `まだ反映していません：${names}。`,
};

/** A length as people say it: 8 mm, 12 cm, 1.2 m. */
function length(mm: number): string {
  if (mm < 10) return `${rounded(mm)} mm`;
  if (mm < 1000) return `${rounded(mm / 10, mm < 100 ? 2 : 3)} cm`;
  return `${rounded(mm / 1000)} m`;
}

export const check: Words['check'] = {
  length,
  triangles: (faces) => `このモデルの三角形は${large(faces)}個です。`,
  fine: '紙で作るのにちょうどよい数です。',
  proposed: (proposal) =>
    `ペーパークラフトではふつう200～1500個なので、${large(proposal)}個に設定しました。図は、その数にしたときの形です。`,
  making: (wanted) => `モデルを作っています（${wanted}）…`,
  shown: (faces) => `図の三角形は${large(faces)}個です。`,
  asItIs: (faces) => `そのまま：${large(faces)}個`,
  all: (faces) => `三角形${large(faces)}個すべて`,
  some: (faces) => `三角形${large(faces)}個`,
  tooMany: (faces, most) =>
    `${large(faces)}個すべては多すぎます。三角形が${large(most)}個を超えると、展開図を作るのに何時間もかかり、` +
    '小さすぎて折れません。',
  bodies: (bodies) =>
    `このモデルは、離れた${large(bodies)}個の立体でできています。それぞれに展開図を作ります。`,
  tiny: (bodies) =>
    `そのうち${large(bodies)}個はとても小さく、モデルの長さの3%もありません。図では色を付けています。`,
  holes: ({ count, small, smallPercent }) => {
    const few = `そのうち${large(small)}個は小さく、幅がモデルの長さの${figure(smallPercent)}%以下です。`;
    const isMixed = small > 0 && small < count;
    return `このモデルには穴が${large(count)}個あります。${isMixed ? few : ''}穴をふさぐ面は、まわりと同じ色になります。`;
  },
  inside: (bodies) =>
    `${large(bodies)}個の立体がほかの立体の中にあり、外から見えません。省くと、切ったり貼ったりする手間が減ります。`,
  netsKept: 'ファイルのとおりに切って折ります。用紙に入るなら、大きさもファイルと同じです。',
  netsOffered: (pieces) =>
    `このファイルには展開図（部品${large(pieces)}個）が入っています。それを使えば作者のとおりに切って折れます。新しく作ることもできます。`,
  size: (p) =>
    `高さ${length(p.height)}、幅${length(p.width)}、奥行き${length(p.depth)}。横は${length(p.pencil)}の鉛筆です。`,
  fits: {
    new: 'シートに入る最大の大きさです。実際の大きさは展開するとわかります。',
    file: 'ファイルと同じか、シートに入る最大の大きさです。実際の大きさは展開するとわかります。',
    other: '実際の大きさは展開するとわかります。',
  },
  chooseHeight: '高さを選ぶと、鉛筆と並べて見られます。',
};

export const form: Words['form'] = {
  height: '高さ（mm）',
  width: '幅（mm）',
  depth: '奥行き（mm）',
  scale: '倍率',
  sheets: 'シートの最大枚数',
  holesUpTo: (percent) => `長さの${figure(percent)}%までふさぐ`,
  solver: {
    tree: '1つの展開図を少しずつ直します。速い方法です。',
    genetic: '論文の方法で、展開図を何世代もかけ合わせます。時間がかかります。',
  },
  folding: {
    prefer: 'ぶつからずに折れる展開図は、そのことを確かめます。それ以外はお知らせします。',
    require: '折れる展開図がないブロックは、折れる部品に分けます。',
    off: '展開図が平らに広がるかどうかだけを見ます。',
  },
};

const pens = '赤い線は切り、青と緑の線は折り筋を付け、ピンクの線はペンで描きます。';

export const printing: Words['printing'] = {
  machine: {
    none: 'はさみやカッターで切るための線です。',
    silhouette: `${pens}印刷したシートの位置は、機械が黒いマークを見て見つけます。`,
    cricut: `${pens}マークはCricutのプログラムが付けます。`,
    generic: pens,
  },
  noColours: 'この機械には線だけを出力します。',
  noPartColours: 'この機械は色の周りを切ってしまうので、色は付けません。',
  noLooks: 'このモデルには元の色がありません。',
  longer: (percent) => `${percent}%長く`,
  shorter: (percent) => `${percent}%短く`,
  correcting: (across, up) =>
    `補正中：線を横に${across}、縦に${up}描きます。もう一度印刷すると、ものさしが50 mmになります。`,
  notCorrecting: 'シートを100%で印刷し、ものさしの実際の長さを入力してください。',
  corrected: (across, up) =>
    `PDFとSVGは、お使いのプリンターに合わせて補正しています（${figure(across)} × ${figure(up)} mm）`,
  frame: '印刷するページ',
  page: (sheet, sheets, width, height) => {
    const size = `${figure(width, 1)} × ${figure(height, 1)} mm`;
    return sheet === null
      ? `組み立て方、${size}`
      : `シート${figure(sheet)}／${figure(sheets)}、${size}`;
  },
  allSheets: (sheets) => (sheets === 1 ? '1枚だけ' : `${figure(sheets)}枚すべて`),
  someSheets: (chosen, sheets) => `${figure(sheets)}枚のうち${figure(chosen)}枚`,
  unreadableRange: '「1-3, 5」のように番号を書いてください',
  beyondRange: (sheets) => `シートは1から${figure(sheets)}までです`,
};
