/** Japanese phrases for what is told of archives and of glTF, 3MF and Pepakura files. */
import type { FileExcess } from '../../model/model-files.js';
import type { FoldEntryFault, Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { all, figure, some } from './numbers.js';

/** What is too much of some files, as a sentence of its own. */
export function excess(fault: FileExcess): string {
  return fault.what === 'too-many'
    ? `ファイルが${figure(fault.most)}個より多くあります`
    : `${figure(fault.megabytes)} MBありますが、読み込めるのは${figure(fault.most)} MBまでです`;
}

const again = 'もう一度入手するか、書き出し直してください';
const exportAgain = '書き出し直してください';

function badArchive(params: Messages['bad-archive']): string {
  const archive = `圧縮ファイル'${shown(params.file)}'`;
  switch (params.what) {
    case 'damaged':
      return `${archive}は壊れているか、途中で切れています。もう一度ダウンロードしてください`;
    case 'bomb':
      return `${archive}は、解凍すると大きさが何百倍にもなります。モデルではありえないので、解凍しませんでした`;
    case 'locked':
      return `${archive}の中の'${shown(params.entry)}'にはパスワードがかかっています。自分で解凍して、モデルを選んでください`;
    case 'method':
      return `${archive}の中の'${shown(params.entry)}'は、読めない方法で圧縮されています。自分で解凍して、モデルを選んでください`;
    case 'too-many':
    case 'too-large':
      return `${archive}は大きすぎます。${excess(params)}。解凍して、モデルとそれに必要なものを選んでください`;
  }
}

/** リストの項目のどこがおかしいか。項目の名前の後に続ける。 */
function foldEntry(params: FoldEntryFault): string {
  switch (params.what) {
    case 'number':
      return 'は数ではありません';
    case 'letter':
      return 'はB、M、V、Fのどれでもありません';
    case 'numbers':
      return `は${figure(params.width)}個の数のリストではありません`;
    case 'list':
      return `は${figure(params.least)}個以上の数のリストではありません`;
    case 'index':
      return `は${figure(params.index)}番ですが、0番から${figure(params.count - 1)}番までしかありません`;
    case 'twice':
      return `は面${figure(params.index)}ですが、この面はもう展開図に入っています`;
  }
}

function badFold(params: Messages['bad-fold']): string {
  const file = `'${shown(params.file)}'`;
  const damaged = `${file}は壊れています。`;
  const frame = 'frame' in params ? `フレーム${figure(params.frame)}` : '';
  switch (params.what) {
    case 'pattern':
      return `${file}には平らな折り図しかなく、折り上がったモデルがありません。折り上がった形（foldedForm）も入れて保存してください`;
    case 'flat':
      return `${file}の折り上がった形は平らです。展開できるのは高さと幅と奥行きのあるモデルだけです`;
    case 'nothing':
      return `${file}はモデルのないFOLDファイルです。折り上がった形（foldedForm）がありません。${again}`;
    case 'cut-off':
      return `${file}は途中で切れています。${again}`;
    case 'no-object':
      return `${file}は、名前と違ってFOLDファイルではありません。${again}`;
    case 'word':
      return `${damaged}${figure(params.line)}行目の${figure(params.character)}文字目に、あるはずのない'${shown(params.word)}'があります。${again}`;
    case 'no-frame':
      return `${damaged}${frame}の中身がフィールドではありません。${again}`;
    case 'missing':
      return `${damaged}${frame}に'${params.key}'がありません。${again}`;
    case 'type':
      return `${damaged}${frame}の'${params.key}'の中身が違うものになっています。${again}`;
    case 'times':
      return `${damaged}${frame}の'${params.key}'の時刻が0から1へ増えていません。${again}`;
    case 'length':
      return `${damaged}${frame}の'${params.key}'には項目が${figure(params.length)}個ありますが、${figure(params.expected)}個のはずです。${again}`;
    default:
      return `${damaged}${frame}の'${params.key}'の項目${figure(params.entry)}${foldEntry(params)}。${again}`;
  }
}

function badGltf(params: Messages['bad-gltf']): string {
  const file = `'${shown(params.file)}'`;
  switch (params.what) {
    case 'truncated':
      return `${file}はデータの途中で終わっています。${again}`;
    case 'json':
      return `${file}には、読めるシーンの記述（JSON）がありません。${again}`;
    case 'structure':
      return `${file}は壊れています。存在しないか、読み取れないデータを使っています。${again}`;
    case 'cycle':
      return `${file}のシーンには、互いを限りなく含み合うノードがあります。${exportAgain}`;
    case 'version': {
      const version =
        params.version === '' ? 'バージョンのない' : `バージョン${shown(params.version)}の`;
      return `${file}は${version}glTFです。読めるのはバージョン2なので、${exportAgain}`;
    }
    case 'extension':
      return `${file}の形は、読めない方法（${shown(params.extension)}）で保存されています。それを使わずに${exportAgain}`;
    case 'short-buffer': {
      const bytes = `${figure(params.announced)}バイトのうち${figure(params.bytes)}バイト`;
      const where =
        params.buffer === '' ? `${file}には` : `${file}に必要な'${shown(params.buffer)}'には`;
      return `${where}、データが${bytes}しかありません。${again}`;
    }
  }
}

function bad3mf(params: Messages['bad-3mf']): string {
  const file = `'${shown(params.file)}'`;
  switch (params.what) {
    case 'no-model':
      return `${file}は、モデルの入っていない3MFパッケージです。${again}`;
    case 'nothing':
      return `${file}には印刷するものがありません。見える物を入れて、プロジェクトを保存し直してください`;
    case 'sliced':
      return `${file}にはスライス済みの印刷データ（G-code）だけがあり、モデルがありません。スライスしたファイルではなく、プロジェクトそのものを保存してください`;
    case 'no-part':
      return `${file}は'${shown(params.part)}'を使っていますが、それが中にありません。${again}`;
    case 'no-object':
      return `${file}は'${shown(params.part)}'のオブジェクト${shown(params.object)}を使っていますが、それがありません。${again}`;
    case 'cycle':
      return `${file}のオブジェクト${shown(params.object)}は、自分自身か、とても多くの物を含んでいます。${exportAgain}`;
    case 'xml':
      return `${file}は壊れています。'${shown(params.part)}'の${figure(params.line)}行目がXMLになっていません。${again}`;
    case 'word':
      return `${file}は壊れています。'${shown(params.part)}'の${figure(params.line)}行目に、別のものがあるはずなのに'${shown(params.word)}'があります。${again}`;
  }
}

function badPdo(params: Messages['bad-pdo']): string {
  const file = `'${shown(params.file)}'`;
  switch (params.what) {
    case 'locked':
      return `${file}には作者がロックをかけています。ロックのないファイルを作者に頼んでください`;
    case 'hidden':
      return `${file}では、すべての立体が非表示です。Pepakura Designerでどれかを表示して、保存し直してください`;
    case 'no-faces':
      return `${file}は、折れる面のないPepakuraのファイルです。${again}`;
    case 'old':
      return `${file}は最初のPepakura Designerのファイルです。読めるのはPepakura Designer 2～6のファイルなので、そのどれかで開いて、保存し直してください`;
    case 'version':
      return `${file}は、ここでは知られていないバージョン（${figure(params.version)}）のPepakuraのファイルです。Pepakura Designer 2～6用か、OBJで保存してください`;
    case 'damaged':
      return `${file}は壊れているか、途中で切れています（${figure(params.at)}バイト目）。もう一度入手するか、Pepakura Designerで保存し直してください`;
  }
}

/** Those kinds that there are, each with its counter: "アニメーション3個、カメラ2台". */
function kinds(counts: readonly (readonly [number, string, string?])[]): string {
  const found = counts.filter(([number]) => number > 0);
  return all(found.map(([number, noun, counter = '個']) => `${noun}${figure(number)}${counter}`));
}

function missingLooks({ what, files }: Messages['missing-looks']): string {
  const those = what === 'pictures' ? '画像' : 'モデルの色と画像のファイル';
  return (
    `${those}${some(files)}がないので、その面は単色になります。` +
    'それも選ぶか、フォルダー全体を選んでください'
  );
}

function unreadPictures({ files, kinds }: Messages['unread-pictures']): string {
  const what =
    kinds.length > 0 ? `は読めない種類（${all(kinds)}）の画像です` : 'は読める画像ではありません';
  return `${some(files)}${what}。PNGかJPEGで保存して、モデルの中の名前もそれに合わせてください`;
}

const lostNets = {
  none: 'ファイルに展開図が入っていない',
  simplified: 'ファイルの展開図が、三角形の変わったモデルに合わない',
  repaired: '面を修復する必要があり、ファイルの展開図を使えなかった',
  flat: 'ファイルの展開図が平らな面の途中を通っていて使えなかった',
} as const;

function keptNets({ pieces, uncut, size }: Messages['file-nets-kept']): string {
  const where = size === 'file' ? 'を、ファイルと同じ大きさで' : 'を';
  const kept = `ファイルの展開図${figure(pieces)}個${where}使いました`;
  return uncut > 0 ? `${kept}。ただし、平らな面の中の切り込み${figure(uncut)}本は省きました` : kept;
}

export const readerMessages = {
  'bad-3mf': bad3mf,
  'bad-archive': badArchive,
  'bad-fold': badFold,
  'bad-gltf': badGltf,
  'bad-pdo': badPdo,
  'missing-files': ({ file, missing }) =>
    `'${shown(file)}'に必要な${some(missing)}がありません。` +
    'それも選ぶか、フォルダー全体を選んでください',
  'no-model-in-archive': ({ file, files }) =>
    files.length === 0
      ? `圧縮ファイル'${shown(file)}'には何もありません`
      : `圧縮ファイル'${shown(file)}'に、読み込めるモデルがありません。中にあるのは${some(files)}です`,
  'reader-not-loaded': () =>
    'この形式を読むプログラムを読み込めませんでした。接続を確かめて、もう一度試してください',
  'uniter-not-loaded': () =>
    '立体をまとめるプログラムを読み込めませんでした。接続を確かめて、もう一度試してください',
  'too-many-triangles': ({ most }) =>
    `モデルの三角形が、読み込める${figure(most)}個を超えています。` +
    '作ったプログラムで簡単にしてください',

  'broken-faces': ({ count }) =>
    `${figure(count)}個の面を省きました。角が足りないか、ファイルにない頂点を使っています`,
  'damaged-extras': () =>
    'ファイルは、形のデータより後ろが壊れています。一部の色と画像、ファイルの展開図が失われました。Pepakura Designerで保存し直してください',
  'damaged-looks': () =>
    `ファイルの色と画像が壊れているので、形だけを読み込みました。${exportAgain}`,
  'large-pictures': ({ files, most, most_mb, most_pixels }) =>
    `${some(files)}を省きました。使える画像は${figure(most)}枚まで、合わせて${figure(most_mb)} MBまで、` +
    `1枚につき${figure(most_pixels / 1e4, 0)}万ピクセルまでです。画像を扱うプログラムで小さくしてください`,
  'lost-looks': ({ count }) =>
    `モデルが使う色や画像のうち${figure(count)}個がファイルにないので、その面は白いままです。${exportAgain}`,
  'missing-looks': missingLooks,
  'picture-guessed': ({ file }) =>
    `モデルに画像の指定がないので、そばにあったただ1枚の画像${shown(file)}を貼りました`,
  'simplified-looks': () =>
    'ファイルで色や画像が重なったり混ざったりしている所では、いちばん上の画像を使い、' +
    'なければ主な色を使います',
  'unknown-materials': ({ names }) =>
    `モデルの材質${some(names)}がどのMTLファイルにもないので、その部分は白いままです`,
  'unread-libraries': ({ files }) =>
    `モデルの色と画像を表すはずの${some(files)}は、壊れているか、MTLファイルではありません。` +
    'モデルを書き出し直してください',
  'unread-pictures': unreadPictures,

  'archive-choice': ({ file, others }) =>
    `圧縮ファイルにはモデルが${figure(others.length + 1)}個あります。'${shown(file)}'を選び、${some(others)}は使いません`,
  'not-for-printing': ({ supports, modifiers, negatives, unprinted }) =>
    `印刷しないとファイルに書かれているので、省きました：${kinds([
      [supports, 'サポート'],
      [modifiers, 'モディファイア'],
      [negatives, '削り取る部分'],
      [unprinted, 'オフになっている物'],
    ])}`,
  'file-nets-kept': keptNets,
  'file-nets-lost': ({ what }) => `${lostNets[what]}ので、新しい展開図を作りました`,
  'file-nets-unused': ({ pieces }) =>
    `ファイルに展開図が${figure(pieces)}個入っていますが、新しい展開図を作りました。ファイルのものを使うには、モデルを確認するときにそれを選んでください（--nets file）`,
  'fold-nets-unused': ({ pieces }) =>
    `ファイルに展開図が${figure(pieces)}個入っていますが、使っていません。折り上がったモデルを新しく展開しました`,
  'parts-unused': ({ parts }) =>
    `${figure(parts)}個のブロックが指定されましたが、ファイルの展開図の分け方をそのまま使いました`,
  'pdo-unused': ({ hidden, texts, images }) =>
    `使わないもの：${kinds([
      [hidden, 'オフになっている立体'],
      [texts, 'シートの文字'],
      [images, 'シートの画像', '枚'],
    ])}`,
  'posed-skins': ({ count }) =>
    `骨組みのある${figure(count)}個のメッシュは、ファイルの最初のポーズになっています`,
  'unknown-extensions': ({ names }) =>
    `ファイルが使っている${some(names)}は、ここでは知られていません。何かが足りないか、違って見えるかもしれません`,
  'unused-content': ({ animations, morphs, uvs, cameras, instances }) =>
    `使わないもの：${kinds([
      [animations, 'アニメーション'],
      [morphs, 'モーフターゲット'],
      [uvs, '2組目のテクスチャー座標', '組'],
      [cameras, 'カメラ', '台'],
      [instances, 'コピーのグループ'],
    ])}`,
} satisfies Partial<Table>;
