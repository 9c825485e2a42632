/** What is said in Japanese of edges, pieces and parts of a result, and of changes of them. */
import type { EdgeName } from '../en/editing.js';
import type { Words } from '../words.js';
import { all, figure, parts } from './numbers.js';

const edge = ({ number, piece }: EdgeName): string =>
  number === null ? `部品${piece}の辺` : `辺${number}`;

/** An edge by its number in a change; null: it has none. */
const edgeOf = (number: string | null): string => (number === null ? '辺' : `辺${number}`);

/** A piece by its name in a change; null: it is not known any more. */
const pieceOf = (name: string | null): string => `部品${name ?? ''}`;

export const edges: Words['edges'] = {
  ontoFace: (own) => `${edge(own)}：面の上に貼ります`,
  withinPiece: (own) => `${edge(own)}：部品${own.piece}の別の辺と貼り合わせます`,
  toPiece: (own, other, sheet) =>
    `${edge(own)}：${sheet === null ? '' : `シート${figure(sheet)}の`}` +
    `${other.number ?? `部品${other.piece}`}と貼り合わせます`,
  border: (piece) => `部品${piece}の辺：モデルの端です`,
  fold: (kind, piece, degrees) =>
    `部品${piece}の${kind === 'mountain' ? '山折り' : '谷折り'}、${figure(degrees)}°`,
  flaps: {
    here: 'のりしろはこちら側にあります。',
    there: 'のりしろは反対側にあります。',
    both: 'のりしろは両側にあります。',
    none: 'のりしろはありません。',
  },
  locks: {
    fold: '固定：この辺は切りません。',
    cut: '固定：この辺は必ず切ります。',
    free: '',
  },
  lockSigns: { fold: '切らない', cut: '必ず切る' },
  gift: (piece) => `この面を${piece}に移す`,
  opensElsewhere: '代わりに、部品の別の場所が開きます。',
  pieces: (after, before) => `部品は${figure(before)}個から${figure(after)}個になりました。`,
  cut: (pieces) => `切りました。${pieces}`,
  joined: (pieces) => `つなげました。${pieces}`,
  noRoomForFlap: 'その側には、のりしろの場所がありません。',
  noRoomForFlaps: 'のりしろ2つ分の場所がありません。',
  roomForFlap: (height) => `ここには${figure(height)} mmの場所しかありません。`,
  notFound: (text) => `「${text}」という辺も部品もありません。`,
  place: (title, number, of) => `${title}：${figure(number)}／${figure(of)}`,
  show: '見る',
  showWhat: (title) => `見る：${title}`,
};

export const pieces: Words['pieces'] = {
  inPlace: (p) =>
    `部品${p.name}、${figure(p.width)} × ${figure(p.height)} mm、シート${figure(p.sheet)}`,
  full: (p) =>
    `部品${p.name}：${figure(p.width)} × ${figure(p.height)} mm、シート${figure(p.sheet)}、面${figure(p.faces)}個`,
  cannotStay: (name, other) =>
    other === null
      ? `${name}はここに置けません。シートの端に近すぎて印刷できません。`
      : `${name}はここに置けません。${other}と重なります。`,
  notDropped: (name, other) =>
    other === null
      ? `${name}を元の場所に戻しました。そこはシートの端に近すぎて印刷できません。`
      : `${name}を元の場所に戻しました。そこでは${other}と重なります。`,
  noRoom: (name, sheet) =>
    `シート${figure(sheet)}には${name}を置く場所がありません。先に別の部品を動かしてください。`,
  laid: {
    kept: (name) => `ほかが動いても、${name}はここから動きません。`,
    moved: (name) => `${name}を動かしました。`,
    turned: (name) => `${name}を回しました。`,
  },
  mayMove: (name) => `${name}はまた動くようになりました。`,
  staysHere: 'ここに固定しています。',
  letMove: '固定を外す',
  keepHere: 'ここに固定',
  newSheet: '新しいシート',
};

export const partWords: Words['parts'] = {
  split: (parts) => (parts > 1 ? '選んだブロックを分ける' : 'このブロックを分ける'),
  merge: (parts) => (parts > 2 ? `この${figure(parts)}個をまとめる` : 'この2個をまとめる'),
  part: (part) => `ブロック${figure(part)}`,
  nameOf: (part) => `ブロック${figure(part)}の名前`,
  name: '名前',
  noNet: '展開図なし',
  pieces: (names) => `部品${all(names)}`,
  faces: (faces) => `面${figure(faces)}個`,
};

export const changes: Words['changes'] = {
  undo: (change) => (change === null ? '元に戻す' : `元に戻す：${change}`),
  redo: (change) => (change === null ? 'やり直す' : `やり直す：${change}`),
  split: (numbers) => `${parts(numbers)}の分割`,
  merge: (numbers) => `${parts(numbers)}の結合`,
  assign: (numbers) => `${parts(numbers)}への面の移動`,
  again: (numbers) => `${parts(numbers)}の別の展開図`,
  name: (numbers) => `${parts(numbers)}の名前`,
  cut: (piece) => (piece === null ? '切る' : `${piece}を切る`),
  join: (piece) => (piece === null ? '折り目にする' : `${piece}の辺を折り目にする`),
  flap: {
    first: (number) => `${edgeOf(number)}ののりしろを反対側へ`,
    second: (number) => `${edgeOf(number)}ののりしろを反対側へ`,
    both: (number) => `${edgeOf(number)}の両側にのりしろ`,
    none: (number) => `${edgeOf(number)}ののりしろをなくす`,
    auto: (number) => `${edgeOf(number)}ののりしろをおまかせに`,
  },
  flapHeight: (edge, height) => `${edge ?? '辺'}ののりしろの高さ${figure(height)} mm`,
  pieceFlaps: (piece) => `${piece ?? '部品'}ののりしろ`,
  lock: (as, number, piece) => {
    const kind = { fold: '切らない', cut: '必ず切る', free: '固定を外す' }[as];
    if (number !== null) return `${edgeOf(number)}：${kind}`;
    return piece === null ? kind : `${piece}の辺：${kind}`;
  },
  paper: {
    size: '大きさの変更',
    strips: 'つなぎ紙の変更',
    numbers: '辺の番号の変更',
    paper: '用紙の変更',
  },
  look: '見た目の変更',
  unpin: (piece) => `${pieceOf(piece)}の固定を外す`,
  place: {
    kept: (piece) => `${pieceOf(piece)}を固定`,
    moved: (piece) => `${pieceOf(piece)}を移動`,
    turned: (piece) => `${pieceOf(piece)}を回転`,
  },
};
