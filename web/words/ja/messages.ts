/** A Japanese phrase for every message, which may be part of a line. */
import { fileMessages } from './files.js';
import { optionFault } from './options.js';
import { paperMessages } from './paper.js';
import { projectMessages } from './projects.js';
import { readerMessages } from './readers.js';
import { repairMessages } from './repair.js';
import type { Messages, Table } from '../messages.js';
import { all, figure, fixed, parts, pieces, some } from './numbers.js';

/** What a stage does, and what helps where memory ends in it. */
const stages = {
  read: ['モデルの読み込みと修復', '作ったプログラムでモデルを簡単にしてください'],
  learn: ['展開の学習', 'モデルの面を減らしてください'],
  cluster: ['ブロック分け', 'モデルの面を減らしてください'],
  search: ['展開図の探索', 'モデルの面を減らしてください'],
  compact: ['のりしろの場所作り', 'モデルの面を減らしてください'],
  paper: [
    'シートへの部品の配置',
    '完成サイズを小さくするか、用紙を小さくするか、面を減らしてください',
  ],
} as const;

const units = { mm: 'ミリメートル', cm: 'センチメートル', m: 'メートル', in: 'インチ' } as const;

/** Sizes with the names of their options. */
const sizes = { height: '高さ', width: '幅', depth: '奥行き' } as const;

function badEdit(params: Messages['bad-edit']): string {
  switch (params.what) {
    case 'no-part-named':
      return '編集にはブロックの指定が必要です';
    case 'no-part':
      return `ブロック${figure(params.part)}はありません。モデルのブロックは${figure(params.parts)}個です`;
    case 'twice':
      return `ブロック${figure(params.part)}が2回指定されています。1つのブロックにできる変更は一度に1つです`;
    case 'apart':
      return `${parts(params.parts)}は隣り合っていないので、1つにまとめられません`;
    case 'into':
      return (
        `${parts(params.parts)}を${figure(params.into)}個のブロックにはできません。1個から${figure(params.most)}個まで` +
        '（平らな面1つにつき1個）にしてください'
      );
  }
}

function badOption(params: Messages['bad-option']): string {
  switch (params.what) {
    case 'height':
    case 'width':
    case 'depth':
      return `${sizes[params.what]}（${params.what}）は0より大きく、${figure(params.most)} mm以下にしてください`;
    case 'scale':
      return `倍率（scale）は0より大きく、${figure(params.most)}以下にしてください`;
    case 'paper':
      return `用紙（paper）は0から${figure(params.most)} mmまでにしてください`;
    case 'pin-sheet':
      return `固定した部品のシートは、最初の${figure(params.most)}枚のどれかにしてください`;
    case 'parts':
      return `ブロックの数（parts）はautoか${figure(params.least)}以上にしてください`;
    case 'proxy':
      return `proxyは${figure(params.least)}以上にしてください`;
    case 'faces':
      return `面の数（faces）は${figure(params.least)}以上にしてください`;
    case 'margin':
      return `余白（margin）は${figure(params.least)} mm以上、用紙の短い辺の半分未満にしてください`;
    case 'sheets':
      return `シートの枚数（sheets）は${figure(params.least)}から${figure(params.most)}までの整数にしてください`;
    case 'flaps':
      return `のりしろ（flaps）は${figure(params.least)}から${figure(params.most)} mmまでにしてください`;
    case 'flap-height':
      return `のりしろの高さは${figure(params.least)}から${figure(params.most)} mmまでにしてください`;
    case 'flap-angle':
      return `のりしろの角度（flap-angle）は${figure(params.least)}から${figure(params.most)}度までにしてください`;
    case 'runs':
    case 'clearance':
    case 'fill-holes':
      return `${params.what}は${figure(params.least)}から${figure(params.most)}までにしてください`;
    case 'repair':
      return `'${params.step}'は止められない修復の処理です`;
    case 'names-of-part':
      return 'ブロックの名前は、ブロック1個につき1つまでです';
    case 'pin-piece':
      return '固定した部品は、ブロックとその面で指定してください';
    case 'pin-place':
      return '固定した部品の場所は、有限の数にしてください';
    case 'name-control':
      return 'ブロックの名前に制御文字は使えません';
    case 'name-colon':
      return 'ブロックの名前にコロンは使えません。コロンは辺の番号の前に付きます';
    case 'name-length':
      return 'ブロックの名前は1～16文字にし、前後に空白を入れないでください';
    case 'name-number':
      return 'ブロックの名前を数にすることはできません。数は辺の番号に使います';
    case 'same-name':
      return `2つのブロックに同じ名前「${params.name}」は付けられません`;
    case 'flap-edge':
      return `頂点${figure(params.from)}から${figure(params.to)}への辺にのりしろを選んでいますが、モデルにその辺がありません`;
    case 'unreadable':
    case 'written':
      return params.detail;
    default:
      return optionFault(params);
  }
}

function faceTooLarge(params: Messages['face-too-large']): string {
  const { face_width_mm, face_height_mm, width_mm, height_mm, share } = params;
  const paper = fixed(Math.ceil(10 / share) / 10, 1);
  return (
    `この大きさでは、${figure(face_width_mm, 0)} x ${figure(face_height_mm, 0)} mmの平らな面が、` +
    `${figure(width_mm, 3)} x ${figure(height_mm, 3)} mmのシートに入りません。` +
    `大きさを${Math.floor(100 * share)}%にするか、${paper}倍の大きさの用紙を使えば入ります`
  );
}

function locked(params: Messages['locked']): string {
  switch (params.what) {
    case 'fold':
      return 'この辺は「切らない」に固定されています';
    case 'cut':
      return 'この辺は「必ず切る」に固定されています';
    case 'faces':
      return '固定した折り目があるので、これらの面は移せません';
    case 'loop':
      return '輪を別の場所で開くことができません。折り目が固定されています';
    case 'parts':
      return `固定した折り目が面をつないでいるので、${figure(params.parts)}個のブロックには分けられません`;
  }
}

/** A time that is only estimated; nothing of one that nobody would mind. */
function roughTime(seconds: number): string {
  if (seconds < 12) return '';
  const time =
    seconds < 90
      ? `${figure(Math.round(seconds / 5) * 5)}秒`
      : `${figure(Math.round(seconds / 60))}分`;
  return `展開図を作るのに約${time}かかり、`;
}

function largeModel({ faces, seconds, proposed }: Messages['large-model']): string {
  return (
    `モデルの面が${figure(faces)}個あります。${roughTime(seconds)}ほとんどの面は小さすぎて折れません。` +
    `ペーパークラフトの面はふつう数百個です（--faces ${proposed}でモデルを簡単にできます）`
  );
}

function partsRaised(params: Messages['parts-raised']): string {
  if (params.what === 'bodies') {
    const bodies = figure(params.bodies);
    return `モデルは離れた${bodies}個の立体なので、ブロックも${bodies}個以上必要です`;
  }
  return (
    `ブロック${figure(params.parts)}個では部品が${figure(params.pieces)}個になるので、` +
    `それぞれが1個の部品になるように、ブロック${figure(params.instead)}個に分けました`
  );
}

function uncheckedPieces({ what, pieces: names }: Messages['unchecked-pieces']): string {
  const help = 'ブロックを増やすか、面を減らすとよくなります';
  if (what === 'large') {
    return `すべての折り目を同じ割合で折っても、${pieces(names)}は折れません。面が多いので、ほかの折り方は探していません。${help}`;
  }
  const reasons = {
    off: '折り方の確認がオフです',
    cancelled: 'その前にキャンセルされました',
    kept: '前の結果をそのまま使いますが、そこに折り方がありませんでした',
    huge: `面が多くて時間がかかりすぎます。${help}`,
  };
  return `${pieces(names)}の折り方は探していません。${reasons[what]}`;
}

export const messages: Table = {
  ...fileMessages,
  ...repairMessages,
  ...paperMessages,
  ...projectMessages,
  ...readerMessages,

  'bad-edit': badEdit,
  'bad-margin': () => '余白だけでシートがなくなります。用紙と余白が合っていません',
  'bad-option': badOption,
  'bad-pin': (params) =>
    params.what === 'outside'
      ? `部品${params.piece}を固定した場所が、シート${figure(params.sheet)}の印刷できる範囲からはみ出しています`
      : `部品${params.pieces.join('と')}が、シート${figure(params.sheet)}で重なって固定されています`,
  'bad-start': () => '前の結果は、このモデルのものではありません',
  'face-too-large': faceTooLarge,
  internal: ({ what, detail }) => `${stages[what][0]}の途中で内部エラーが起きました：${detail}`,
  'no-depth': () => 'モデルに奥行きがないので、大きさを合わせられません',
  'no-height': () => 'モデルに高さがないので、大きさを合わせられません',
  'no-width': () => 'モデルに幅がないので、大きさを合わせられません',
  'out-of-memory': ({ what }) =>
    what === 'file'
      ? 'モデルのファイルに必要なメモリーが足りません'
      : `${stages[what][0]}に必要なメモリーが足りません。${stages[what][1]}`,
  'too-many-faces': ({ faces, most, proposed }) =>
    `モデルに平らな面が${figure(faces)}個あります。${figure(most)}個を超えると、展開図を作るのに何時間もかかり、小さすぎて折れません。--faces ${proposed}で、折れる簡単なモデルにできます`,
  'too-few-sheets': () => 'どんな大きさにしても、部品がこの枚数のシートに入りません',

  'edit-place-gone': ({ what }) =>
    ({
      edge: 'そこにはもう同じ辺がありません',
      faces: 'そこにはもう同じ面がありません',
      part: 'そこにはもう同じブロックがありません',
      piece: 'そこにはもう同じ部品がありません',
    })[what],
  'already-cut': () => 'この辺はもう切ってあります',
  'already-joined': () => 'この辺はもう折り目です',
  locked,
  'inside-panel': () => 'この辺は平らな面の中にあります。平らな面は切りません',
  'no-edge': ({ from, to }) => `モデルには、角${figure(from)}と角${figure(to)}を結ぶ辺がありません`,
  'no-face': (params) =>
    params.what === 'none'
      ? '面が指定されていません'
      : `モデルの面は0から${figure(params.most)}までです`,
  'no-net': () => 'この辺の隣に、まだ展開図のない面があります',
  'no-part': ({ part, parts: all }) =>
    `ブロック${figure(part)}はありません。モデルのブロックは${figure(all)}個です`,
  'not-in-loop': () => 'そこを切っても輪は開きません',
  'not-touching': () => 'これらの面は、そのブロックと隣り合っていません',
  overlap: ({ what }) =>
    what === 'pieces'
      ? 'そこでは2つの部品が重なります'
      : '代わりにどこを開いても、部品の面どうしが重なります',
  'would-fall-apart': ({ what, part }) =>
    `${what === 'fold' ? 'この折り目' : 'これらの面'}がないと、ブロック${figure(part)}がばらばらになります`,

  'files-ignored': ({ files }) =>
    `ほかの${figure(files.length)}個のファイルは必要ありませんでした：${some(files)}`,
  'faces-above-wish': ({ faces }) =>
    `面を${figure(faces)}個まで減らしました。これより減らすと表面が壊れます`,
  joints: ({ what, count }) =>
    `${figure(count)}本の辺は、続きになっていない面の上に貼ります` +
    (what === 'numbered' ? '。そこで同じ番号を探してください' : ''),
  'joints-lost': ({ count }) =>
    `ほかの面の上に立っていた${figure(count)}本の辺が、モデルを簡単にしたときに離れました。見た目に合わせて貼ってください`,
  'large-model': largeModel,
  'colour-numbers': () =>
    'ファイルでは面の色が番号で書かれていて、どの色かわからないので、色は印刷しません',
  'meets-itself': ({ part }) =>
    `ブロック${figure(part)}には、モデルの中で突き抜け合う面があります。どう折っても面がぶつかります`,
  'no-motion': ({ part }) =>
    `ブロック${figure(part)}を、面どうしがぶつからずに続けて折る方法が見つかりませんでした`,
  'part-split': ({ what, part, pieces: number }) =>
    `ブロック${figure(part)}は、1個の部品では${what === 'no-motion' ? '折れない' : '展開図にできない'}ので、` +
    `${figure(number)}個の部品になりました`,
  'parts-lowered': ({ panels }) =>
    `モデルの平らな面は${figure(panels)}個だけなので、ブロックをそれより多くはできません`,
  'parts-raised': partsRaised,
  'pin-lost': ({ count }) =>
    `固定した${figure(count)}個の部品は、前と同じ形ではなくなったので、置き直しました`,
  'small-bodies': ({ count, limit_mm }) =>
    `モデルの立体のうち${figure(count)}個は、${figure(limit_mm)} mmより小さいので省きました`,
  'smaller-saves-sheets': ({ what, size_mm, instead_mm, sheets, of }) =>
    `${sizes[what]}を${figure(Math.round(instead_mm))} mmから${figure(size_mm)} mmにすれば、` +
    `シートが${figure(of)}枚から${figure(sheets)}枚になるはずです`,
  'sheet-split': ({ part, pieces: number }) =>
    `ブロック${figure(part)}はシートに入らないので、${figure(number)}個の部品に切り分けました`,
  'run-stopped': () =>
    '探すのが途中で止められ、そこまでに見つかったものがここにあります。最後まで探すには、もう一度展開してください',
  'unchecked-pieces': uncheckedPieces,
  'unit-guessed': ({ unit }) => `モデルの単位がわからないので、${units[unit]}としました`,
  'up-guessed': () => 'ファイルにどちらが上か書かれていないので、この形式で多いz軸を上にしました',
  'weak-necks': ({ pieces: names }) =>
    '5 mmより短い折り目の両側にたくさんの面があり、破れるかもしれません。裏をテープで補強してください：' +
    pieces(names),

  'engine-died': ({ reason, times }) =>
    times === undefined
      ? `計算プログラムが突然止まりました：${reason}`
      : `計算プログラムが同じ作業で${figure(times)}回、突然止まりました：${reason}`,
  overtaken: () => 'その間に、別の操作が元に戻されたか、やり直されました',
  'no-piece': ({ piece, pieces: all }) =>
    `部品${figure(piece)}はありません。部品は${figure(all)}個です`,
  'not-pinned': ({ piece }) => `部品${figure(piece)}は固定されていません`,
  'not-together': () =>
    '一度にまとめてできるのは、のりしろだけの編集か、ブロックを分けたりまとめたりする編集だけです',
  'no-legend': () => '凡例を置く場所が、どのシートにもありません',
  'beyond-page': ({ by_mm, margin_mm }) =>
    `このプリンターに合わせて補正すると、線がページの端から${fixed(by_mm, 1)} mmはみ出します。余白を${figure(margin_mm)} mm（--margin ${margin_mm}）にすると、はみ出しません`,
  'missing-glyphs': ({ letters }) =>
    `${letters.join(' ')}のあるフォントがないので、代わりに四角を印刷します`,
  'fonts-not-loaded': () =>
    '一部の文字のフォントを読み込めなかったので、開いたプログラムのフォントで表示されます',
  'marks-not-free': ({ pieces: names, margin_mm }) =>
    '機械がマークを探す場所に、切る線があります。' +
    `余白を${figure(margin_mm)} mmにすると空けられます：${pieces(names)}`,
  'cricut-area': ({ sheets, width_mm, height_mm, margin_mm }) =>
    `Cricutで印刷してから切れるのは、この用紙では${Math.floor(width_mm)} x ${Math.floor(height_mm)} mmまでです。` +
    `シート${all(sheets.map((sheet) => figure(sheet)))}は入らないので、` +
    `印刷せずに切るか、余白を${figure(margin_mm)} mmにしてください`,
};
