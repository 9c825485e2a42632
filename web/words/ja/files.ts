/** Japanese phrases for what is told of files: why one cannot be read, and what was mended or noticed in it. */
import { fillingFor } from '../../model/holes.js';
import type { Messages, Table } from '../messages.js';
import { figure, rounded } from './numbers.js';

const quoted = (word: string): string => `'${word}'`;

const places: Readonly<Record<string, (at: string) => string>> = {
  line: (at) => `${at}行目`,
  vertex: (at) => `${at}番目の頂点`,
  face: (at) => `${at}番目の面`,
  element: (at) => `${at}番目の要素`,
  triangle: (at) => `${at}番目の三角形`,
  count: (at) => `${at}番目の数`,
};

/** "23行目", or nothing where no place is known. */
function placeOf({ place, at }: { place?: string; at?: number }): string {
  if (place === undefined || at === undefined) return '';
  return places[place]?.(figure(at)) ?? `${place} ${figure(at)}`;
}

/** "23行目：", before a sentence. */
function prefix(params: { place?: string; at?: number }): string {
  const place = placeOf(params);
  return place && `${place}：`;
}

/** Where something is, after its sentence: "（23行目）", or of several where the first one is. */
function suffix(params: { place?: string; at?: number; count: number }): string {
  const place = placeOf(params);
  if (place === '') return '';
  return params.count > 1 ? `（最初は${place}）` : `（${place}）`;
}

const counted = {
  vertex: (number: string) => `${number}個の頂点`,
  face: (number: string) => `${number}個の面`,
  edge: (number: string) => `${number}本の辺`,
} as const;

/** "2個の面を裏返しました" */
function told(noun: keyof typeof counted, what: string): (params: { count: number }) => string {
  return ({ count }) => `${counted[noun](figure(count))}${what}`;
}

const saveAs = '作ったプログラムで、GLB、OBJ、STL、3MF、PLY、OFFのどれかで保存してください';
const readFormats = '読み込めるのはOBJ、STL、OFF、PLY、GLB、glTF、3MF、PDO、FOLDです';

/** Endings of formats that are read, and whose contents say that they are. */
const readByContents: readonly string[] = ['glb', 'gltf', '3mf', 'pdo', 'zip'];

/** Models and projects of other programs, by the words of the engine or by the endings of their names. */
const models: Readonly<Record<string, string>> = {
  glb: 'GLB（バイナリglTF）のモデル',
  gltf: 'glTFのモデル',
  '3mf': '3MFのモデル',
  fbx: 'FBXのモデル',
  step: 'STEPのモデル',
  stp: 'STEPのモデル',
  iges: 'IGESのモデル',
  igs: 'IGESのモデル',
  blend: 'Blenderのプロジェクト',
  skp: 'SketchUpのモデル',
  '3dm': 'Rhinoのモデル',
  vrml: 'VRMLのモデル',
  wrl: 'VRMLのモデル',
  vox: 'MagicaVoxelのモデル',
  draco: 'Dracoのモデル',
  drc: 'Dracoのモデル',
  dae: 'COLLADA（DAE）のモデル',
  x3d: 'X3Dのモデル',
  amf: 'AMFのモデル',
  '3ds': '3DSのモデル',
  max: '3ds Maxのプロジェクト',
  c4d: 'Cinema 4Dのプロジェクト',
  ma: 'Mayaのプロジェクト',
  mb: 'Mayaのプロジェクト',
  lwo: 'LightWaveのモデル',
  usd: 'USDのモデル',
  usda: 'USDのモデル',
  usdc: 'USDのモデル',
  usdz: 'USDZのモデル',
  f3d: 'Fusionのプロジェクト',
  sldprt: 'SolidWorksの部品',
  scad: 'OpenSCADのプログラム',
  fcstd: 'FreeCADのプロジェクト',
};

/** Other files that people take for models. */
const others: Readonly<Record<string, string>> = {
  zstandard: '圧縮されたBlenderのプロジェクトか、ほかのZstandardの圧縮ファイル',
  dxf: 'DXFの図面',
  dwg: 'DWGの図面',
  pdf: 'PDFの文書',
  ps: 'PostScriptの文書',
  png: 'PNGの画像',
  jpeg: 'JPEGの画像',
  gif: 'GIFの画像',
  gzip: 'gzipの圧縮ファイル',
  '7z': '7-Zipの圧縮ファイル',
  rar: 'RARの圧縮ファイル',
  'git-lfs': 'Git LFSの、モデルの場所を示すだけのファイル',
  svg: 'SVGの図',
  html: 'ウェブページ',
  xml: 'XMLの文書',
  json: 'JSONの文書',
  zip: 'ZIPの圧縮ファイル',
};

function badHeader(params: Messages['bad-header']): string {
  switch (params.what) {
    case 'property-type':
      return `${prefix(params)}${quoted(params.word)}はプロパティの型ではありません`;
    case 'encoding':
      return `${prefix(params)}${quoted(params.word)}はPLYの符号化方式ではありません`;
    case 'ply-magic':
      return `${prefix(params)}PLYファイルは'ply'で始まりますが、このファイルは${quoted(params.word)}で始まっています`;
    case 'off-magic':
      return `${prefix(params)}OFFファイルはOFFで始まりますが、このファイルは${quoted(params.word)}で始まっています`;
    case 'keyword':
      return `${prefix(params)}${quoted(params.word)}はヘッダーのキーワードではありません`;
    case 'element-count':
      return `${prefix(params)}要素${quoted(params.element)}には、0以上の個数が必要です`;
    case 'property-first':
      return `${prefix(params)}要素より前にプロパティがあります`;
    case 'no-format':
      return `${prefix(params)}'format'の行がないままヘッダーが終わっています`;
    case 'counts':
      return `${prefix(params)}個数は0以上でなければなりません`;
    case 'dimensions':
      return `頂点が${figure(params.dimensions)}次元です。展開できるのは3次元のモデルだけです`;
    case 'property': {
      const list = params.property === 'vertex_indices' ? '（リスト）' : '';
      return `要素${quoted(params.element)}には、プロパティ${quoted(params.property)}${list}が1つ必要です`;
    }
  }
}

function badIndex(params: Messages['bad-index']): string {
  const { index, vertices } = params;
  const face = `${prefix(params)}面が頂点${figure(index)}を使っていますが、`;
  if (params.what === 'before') return `${face}その前には頂点が${figure(vertices)}個しかありません`;
  const from = params.first === 0 ? '（0から数えます）' : '';
  return `${face}ファイルの頂点は${figure(vertices)}個です${from}`;
}

function badNumber(params: Messages['bad-number']): string {
  const [place, word] = [prefix(params), quoted(params.word)];
  if (params.what === 'comma') return `${place}${word}に、あるはずのないコンマがあります`;
  const wanted = params.what === 'whole' ? '整数' : '数';
  return `${place}${wanted}があるはずの場所に${word}があります`;
}

const noFaces = {
  nothing: 'ファイルに頂点も面もありません',
  vertices: 'ファイルに頂点はありますが、面がありません。点と線だけでは展開できません',
  surfaces: "ファイルに自由曲面（'surf'）はありますが、面がありません。ポリゴンで保存してください",
  model: 'モデルに面がありません',
} as const;

function truncated(params: Messages['truncated']): string {
  switch (params.what) {
    case 'number':
      return `${prefix(params)}数があるはずの場所でファイルが終わっています`;
    case 'coordinates':
      return `${prefix(params)}頂点の座標が3つありません`;
    case 'corners':
      return `${prefix(params)}面の頂点が、書かれた数より少なくなっています`;
    case 'face':
      return `${prefix(params)}面の途中でファイルが終わっています`;
    case 'ply-header':
      return `${prefix(params)}'end_header'の前にファイルが終わっています`;
    case 'more':
      return `${prefix(params)}まだ続きがあるはずなのに、ファイルがここで終わっています`;
    case 'stl-header':
      return `ファイルが${figure(params.bytes)}バイトしかなく、バイナリSTLのヘッダーに足りません`;
    case 'triangles':
      return `${prefix(params)}ファイルがここで終わっていますが、ヘッダーでは三角形が${figure(params.announced)}個あるはずです`;
    case 'element':
      return `${prefix(params)}ファイルがここで終わっていますが、ヘッダーでは要素${quoted(params.element)}が${figure(params.announced)}個あるはずです`;
    case 'keyword':
      return `${prefix(params)}${quoted(params.expected)}があるはずの場所でファイルが終わっています`;
    case 'vertices':
    case 'faces':
      return `${prefix(params)}${params.what === 'vertices' ? '頂点' : '面'}${figure(params.announced)}個のうち${figure(params.done)}個でファイルが終わっています`;
    case 'header-only':
      return `${prefix(params)}ヘッダーの後でファイルが終わっています`;
  }
}

/** What a file of a format that is not read is, and what to do, to be read after "は". */
function unread(format: string): string {
  const model = models[format];
  if (model !== undefined) return `${model}なので読み込めません。${saveAs}`;
  return `${others[format] ?? format}なので読み込めません。${readFormats}`;
}

function unknownFormat(params: Messages['unknown-format']): string {
  switch (params.what) {
    case 'contents':
      return `このファイルは${unread(params.format)}`;
    case 'file':
      return `'${params.file}'は${unread(params.format)}`;
    case 'ending':
      // Readers see by its contents whether a file is theirs.
      if (readByContents.includes(params.ending)) {
        return `ファイルの拡張子は.${params.ending}ですが、始まりがそれらしくありません。壊れているか、別の種類のファイルです。もう一度入手するか、保存し直してください`;
      }
      return params.ending in models
        ? `このファイルは、拡張子によると${unread(params.ending)}`
        : `'.${params.ending}'で終わるファイルは読み込めません。${readFormats}`;
    case 'nothing':
      return `ファイルの中身からも拡張子からも、形式がわかりません。${readFormats}`;
  }
}

function ignoredElements({
  points,
  lines,
  curves,
  surfaces,
}: Messages['ignored-elements']): string {
  const kinds = [
    [points, '点', '個'],
    [lines, '線', '本'],
    [curves, '自由曲線', '本'],
    [surfaces, '自由曲面', '個'],
  ] as const;
  const found = kinds.filter(([number]) => number > 0);
  const list = found.map(([number, noun, counter]) => `${noun}${figure(number)}${counter}`);
  return `折れるのは面だけなので、次のものは使いません：${list.join('、')}`;
}

function openBorder(params: Messages['open-border']): string {
  if (params.what === 'edge') {
    return 'この辺がある面は1つだけです。ここで貼り合わせるものはありません';
  }
  return (
    `${figure(params.count)}本の辺が、${figure(params.bodies)}個の開いた面のふちにあります。開いた面には厚みがなく、紙1枚として印刷するので、白い裏側が見えます。モデルの大きさの${rounded(params.gap)}倍より広いすき間や、` +
    '隣の辺に比べて広いすき間は、開いたままにします'
  );
}

function openHoles(params: Messages['open-holes']): string {
  const { count, percent, small, small_percent } = params;
  const widest = count === 1 ? '幅' : 'いちばん広い穴の幅';
  const few = `。--fill-holes ${small_percent}なら小さい${figure(small)}個だけ`;
  return (
    `穴が${figure(count)}個開いたままです。${widest}は、モデルのいちばん長い辺の${figure(percent)}%です` +
    `（--fill-holes ${fillingFor(percent)}でふさげます${small > 0 && small < count ? few : ''}）`
  );
}

export const fileMessages = {
  'bad-header': badHeader,
  'bad-index': badIndex,
  'bad-number': badNumber,
  'bad-size': ({ least, most }) =>
    `モデルの大きさが範囲の外です。使えるのは${least.toExponential()}から${most.toExponential().replace('+', '')}までです`,
  'bad-syntax': (params) =>
    `${prefix(params)}${quoted(params.expected)}があるはずの場所に${quoted(params.word)}があります`,
  'bad-text': (params) => `${prefix(params)}文字の中にNULバイトがあります。ファイルが壊れています`,
  'empty-file': () => 'ファイルが空です',
  'no-area': ({ what }) =>
    what === 'point'
      ? 'モデルの頂点がすべて同じ場所にあります'
      : 'モデルに、面積のある面がありません',
  'no-faces': ({ what }) => noFaces[what],
  'not-finite': (params) =>
    params.what === 'weight'
      ? `${prefix(params)}頂点の4つ目の座標が0です。0は使えません`
      : `${prefix(params)}座標が有限の数ではありません`,
  'too-many-corners': ({ face, corners, most }) =>
    `面${figure(face)}には角が${figure(corners)}個あります。使えるのは${figure(most)}個までです`,
  truncated,
  'unknown-format': unknownFormat,
  'no-model': ({ count }) =>
    `${figure(count)}個のファイルの中に、読み込めるモデルがありません。${readFormats}`,
  'several-models': ({ count, first, second }) =>
    count === 2
      ? `ファイルの中にモデルが2つあります：'${first}'と'${second}'。どちらかを選んでください`
      : `ファイルの中にモデルが${figure(count)}個あります：'${first}'、'${second}'など。1つを選んでください`,

  'closed-cracks': ({ count, width }) =>
    `${figure(count)}本の辺を、すき間をふさいで隣の辺とつなぎました。いちばん広いすき間は、モデルの単位で${rounded(width)}です`,
  'closed-t-junctions': told('edge', 'を、すき間をふさぐために隣の頂点の所で切りました'),
  'crossing-bodies': ({ count, unitable }) =>
    `${figure(count)}組の立体が突き抜け合っています。組み立てると部品がぶつかるので、` +
    (unitable > 0
      ? '1つにまとめてください（--crossing unite）'
      : 'モデルを作るプログラムで1つにまとめてください'),
  'crossings-unchecked': ({ count }) =>
    `面が${figure(count)}個と多すぎるので、立体が突き抜け合っていないか、ほかの立体の中にないかは調べていません`,
  'counts-from-zero': () =>
    'この形式では頂点を1から数えますが、このファイルは0から数えているので、そのとおりに読みました',
  'cut-nonorientable': told('edge', 'を切り開きました。面に表と裏の区別がないためです'),
  'cut-off': (params) =>
    `${prefix(params)}ファイルが途中で終わっています。そこまでの${figure(params.count)}個の面を使います`,
  'decimal-commas': ({ count }) =>
    `${figure(count)}個の数にコンマがあったので、小数点として読みました`,
  'dropped-degenerate-faces': told('face', 'を、面積がないので取り除きました'),
  'dropped-duplicate-faces': told('face', 'を、別の面と同じなので取り除きました'),
  'dropped-inner-bodies': ({ count, faces }) =>
    `${figure(count)}個の立体（面${figure(faces)}個）は、ほかの立体の中にあって見えないので省きました`,
  'dropped-misnumbered-faces': (params) =>
    told('face', 'を、ファイルにない頂点を使っているので取り除きました')(params) + suffix(params),
  'dropped-placeless-faces': (params) =>
    told('face', 'を、頂点の座標が使えないので取り除きました')(params) +
    suffix({ ...params, count: 1 }),
  'dropped-unused-vertices': told('vertex', 'を、使う面がないので取り除きました'),
  'filled-holes': ({ count }) => `${figure(count)}個の穴を、まわりと同じ色の新しい面でふさぎました`,
  'flattened-faces': ({ count, distance }) =>
    `${figure(count)}個の面を、描かれたとおり完全に平らにしました。角が動いた距離は、モデルの単位で${rounded(distance)}以下です`,
  'flipped-faces': told('face', 'を裏返して、すべての面の表側をそろえました'),
  'halved-edges': told('edge', 'を半分に分けました。2本の辺が同じ頂点を結んでいたためです'),
  'huge-holes': ({ count, edges }) =>
    `${figure(count)}個の穴は開いたままです。ふさげるのは、辺が${figure(edges)}本までの穴だけです`,
  'ignored-elements': ignoredElements,
  'inner-bodies': ({ count }) =>
    `${figure(count)}個の立体が、ほかの立体の中にあり、外から見えません（--inside dropで省けます）`,
  'lost-picture-places': ({ count }) =>
    `面の角${figure(count)}個が、ファイルにない画像の位置を指しています。これらの面は単色になります`,
  'merged-two-sided': told(
    'face',
    'は、裏側からもう一度描かれたものでした。表と裏を1枚の紙にまとめました',
  ),
  'missing-endsolid': () =>
    "'endsolid'がないままファイルが終わっています。最後の三角形が足りないかもしれません",
  'not-united': ({ count, open }) =>
    `ほかの立体を突き抜けている${figure(count)}個の立体は、` +
    (open === count
      ? '閉じていないのでまとめられませんでした（--fill-holes allで閉じられます）'
      : 'まとめられませんでした。モデルを作るプログラムで1つにまとめてください'),
  'open-border': openBorder,
  'open-holes': openHoles,
  'other-format': ({ ending, format }) => `ファイルの拡張子は.${ending}ですが、中身は${format}です`,
  'self-crossing-bodies': ({ count }) =>
    `${figure(count)}個の立体が自分自身を突き抜けています。組み立てると部品がぶつかるので、` +
    'モデルを作るプログラムで直してください',
  'split-nonmanifold-edges': told('edge', 'には3つ以上の面が集まっていたので、切り離しました'),
  'split-nonmanifold-vertices': told(
    'vertex',
    'では面どうしが触れているだけなので、切り離しました',
  ),
  'trailing-bytes': ({ count }) => `最後の三角形の後の${figure(count)}バイトは使いませんでした`,
  'trailing-lines': ({ count }) => `最後の面の後の${figure(count)}行は使いませんでした`,
  'triangulated-polygons': told('face', 'には角が4つ以上あったので、三角形に分けました'),
  'unfilled-holes': ({ count }) =>
    `${figure(count)}個の穴は開いたままです。面を張ると、モデルを突き抜けるか、モデルに重なってしまいます`,
  'united-bodies': ({ count, faces }) =>
    `突き抜け合っていた${figure(count)}個の立体を1つにまとめました` +
    (faces > 0 ? `（中に隠れた面${figure(faces)}個はなくなりました）` : ''),
  'welded-vertices': told('vertex', 'を、同じ場所の頂点と1つにまとめました'),
  'wrong-count': ({ count, announced }) =>
    `ヘッダーでは三角形が${figure(announced)}個のはずですが、ファイルには${figure(count)}個あります。すべて読み込みました`,
} satisfies Partial<Table>;
