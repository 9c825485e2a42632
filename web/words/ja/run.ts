/** What is said in Japanese while a model is unfolded, and of what comes of it. */
import type { Words } from '../words.js';
import { figure, fixed } from './numbers.js';

const sheetsOf = (sheets: number, paper: string): string => `${paper}のシート${figure(sheets)}枚`;

export const run: Words['run'] = {
  stages: {
    read: 'モデルを読み込んでいます',
    learn: 'うまく一緒に展開できる面を学習しています',
    cluster: 'ブロックを決めています',
    search: 'ブロックを平らに広げています',
    compact: 'のりしろの場所を作っています',
    paper: '部品をシートに並べています',
  },
  stageLines: {
    read: 'モデルの読み込み',
    learn: '展開の学習',
    cluster: 'ブロック分け',
    search: '展開図の探索',
    compact: 'のりしろの場所作り',
    paper: 'シートへの配置',
  },
  detailed: (stage, detail) => `${stage}：${detail}`,
  learned: (runs, of) => `${figure(of)}回のうち${figure(runs)}回の展開を試しました`,
  partsDone: (done, parts) => `ブロック${figure(parts)}個のうち${figure(done)}個が完了`,
  overlapsLeft: (overlaps) => `重なりは残り${figure(overlaps)}か所`,
  minutesLeft: (minutes) => `残り約${figure(minutes)}分`,
  secondsLeft: (seconds) => `残り約${figure(seconds)}秒`,
  goingBack: '元に戻しています。',
  stopping: 'できた部品をシートに並べています。',

  done: (lead) => `完了：${lead}`,
  stopped: (lead) => `停止しました。${lead}`,
  undone: (lead) => `元に戻しました：${lead}`,
  madeAgain: (lead) => `やり直しました：${lead}`,
  hold: (why) => `モデルを確認してください。${why}`,
  named: (name) => `「${name}」という名前を付けました。`,
  nameGone: '名前を消しました。',
  editCancelled: 'キャンセルしました。すべて元のままです。',
  unfoldAgain: 'もう一度展開',

  farewells: { cancelled: 'キャンセルしました。', empty: '停止しました。' },
  notes: {
    cancelled: 'キャンセルしました。ここまで進みましたが、何も残していません。',
    empty: '停止しました。ここまで進みました。',
    failed: 'ここまで進みました。',
    undrawn: '展開図は見つかりましたが、描けませんでした。',
  },
  nextSteps: {
    file: '別のモデルを選ぶか、このモデルを直してもう一度試してください。',
    job: '設定を変えてもう一度試すか、別のモデルを選んでください。',
    crash:
      'ほかに失われたものはなく、次は最初から始まります。もっと小さいモデルなら、うまくいくかもしれません。',
  },
  nothingToUse: [
    '使えるものがまだありません',
    '探すのをやめたとき、展開図のあるブロックがありませんでした。最後のものは変更の途中でした。次はもう少し長く待ってください。',
  ],
  notUnfolded: (model) => `「${model}」を展開できませんでした`,
  stillThere: (model) => `下にあるのは、前の「${model}」の結果です。`,
  notDrawn: (model) => `「${model}」のシートを描けませんでした`,
  notWritten: (format) => `${format}のファイルを書き出せませんでした`,
  projectNotWritten: 'プロジェクトのファイルを書き出せませんでした',
  resultIsHere: '結果はまだここにあります。',
  notPrinted: 'ページを印刷できませんでした',
  onceMore: 'もう一度試してください。',
  nothingChanged: '何も変わっていません',
  nothingUnfolded: '何も展開していません',
  noBrowser: 'このブラウザーではFoldwrightが動きません',
  browserLacks:
    'このブラウザーには、展開に必要なモジュールワーカー、またはSIMDと例外処理に対応したWebAssemblyがありません。' +
    'ChromeとEdgeは95、Firefoxは114、Safariは16.4以降のバージョンで使えます。',
};

export const result: Words['result'] = {
  onePiece: (sheets, paper) => `全体が1個の部品で、${sheetsOf(sheets, paper)}に入りました。`,
  eachInOne: (parts, sheets, paper) =>
    `ブロック${figure(parts)}個がそれぞれ1個の部品になり、${sheetsOf(sheets, paper)}に入りました。`,
  inPieces: (parts, pieces, sheets, paper) =>
    `ブロック${figure(parts)}個が${figure(pieces)}個の部品になり、${sheetsOf(sheets, paper)}に入りました。`,
  withHoles: (p) => {
    const whole =
      p.finished === 0
        ? `ブロック${figure(p.parts)}個のうち、完成したものはありません`
        : `ブロック${figure(p.parts)}個のうち、完成したのは${figure(p.finished)}個だけです`;
    return (
      `${whole}（部品${figure(p.pieces)}個、${sheetsOf(p.sheets, p.paper)}）。` +
      `残りの${figure(p.parts - p.finished)}個がないので、モデルに穴が開きます。すべて作るには、もう一度展開してください。`
    );
  },
  facts: {
    pieces: 'ピース',
    sheets: '用紙',
    size: '完成サイズ',
    smallest: '最小の部品',
    glue: '貼る長さ',
    flaps: 'のりしろ',
    numbers: '辺の番号',
    scale: '縮尺',
    paper: '使う用紙',
    triangles: '三角形',
    time: '計算時間',
  },
  none: 'なし',
  smallest: (name, width, height) => `${name}、${figure(width)} × ${figure(height)} mm`,
  glue: (metres, seams) => `つなぎ目${figure(seams)}か所で${fixed(metres, 1)} m`,
  flaps: (p) => {
    const words: string[] = [];
    if (p.wanted > 0) words.push(`つなぎ目${figure(p.wanted)}か所のうち${figure(p.flaps)}か所`);
    if (p.shrunk > 0) words.push(`そのうち${figure(p.shrunk)}か所は細い`);
    if (p.strips > 0) words.push(`つなぎ紙${figure(p.strips)}枚`);
    if (p.taped > 0) words.push(`テープで${figure(p.taped)}か所`);
    return words.join('、');
  },
  numbers: (printed, seams) => `つなぎ目${figure(seams)}か所のうち${figure(printed)}か所`,
  scale: (mm) => `1単位が${figure(mm)} mm`,
  percent: (percent) => `${figure(percent)}%`,
  seconds: (seconds, digits) => `${fixed(seconds, digits)}秒`,
  minutes: (minutes, seconds) => `${figure(minutes)}分${figure(seconds)}秒`,
  repaired: '展開する前に直した点',
  worthKnowing: '知っておくとよいこと',
  sheet: (sheet, sheets) => `シート${figure(sheet)}／${figure(sheets)}`,
  caption: (sheet, sheets, names) =>
    `シート${figure(sheet)}／${figure(sheets)}：部品${names.join('、')}`,
  forModel: (percent) => `モデルに${figure(percent)}%を使用`,
};

export const pictures: Words['pictures'] = {
  matrixToCome: '面の組み合わせ1つが1つの点になります',
  nothingLearned: 'このブロックでは、学習の必要がありませんでした',
  blocks: '枠の1つがブロック1個',
  darker: '濃いほど、一緒になることが多い',
  netToCome: 'ブロックを決めた後に出ます',
  netBegins: 'すぐに始まります',
  generation: (part, generation, overlaps) =>
    `ブロック${figure(part)}、第${figure(generation)}世代：重なり${figure(overlaps)}か所`,
  netDone: (part) => `ブロック${figure(part)}、重なりなし`,
  couldBePrinted: (sheets) =>
    `この${figure(sheets)}枚のシートはもう印刷できます。いま展開図をもっと作りやすくしています`,
  netsToCome: '平らに広がったものから、ここに出ます',
  netsFound: (nets) =>
    `これまでに展開図が${figure(nets)}個見つかりました。記号とシートは最後にできます`,
  noWebGl: 'このブラウザーにはWebGL 2がないので、3D表示ができません。ほかの機能は使えます。',
  broken: '3D表示はここでは動きません。ほかの機能は使えます。',
};
