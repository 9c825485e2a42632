/** What the cover and the pages with the steps say in Japanese. */
import type { BuildingWords, EdgeList } from '../building.js';
import { all, figure } from './numbers.js';

const views = {
  'front-left': '左前から見たところ',
  'back-right': '右後ろから見たところ',
  'front-right': '右前から見たところ',
  'back-left': '左後ろから見たところ',
  above: '上から見たところ',
  below: '下から見たところ',
} as const;

const marks = {
  'close-first': '閉じる：始まり',
  'close-last': '閉じる：最後の辺',
  'glue-first': '貼る：始まり',
  'glue-last': '貼る：最後の辺',
  valley: '谷折り',
  border: 'この色の部品に貼る',
} as const;

const creases = { mountain: '山折り', valley: '谷折り' } as const;

/** "約40分", "約3時間半": nobody works to the minute. */
function duration({ seconds }: { seconds: number }): string {
  const minutes = seconds / 60;
  if (minutes < 57.5) return `約${figure(Math.max(5, 5 * Math.round(minutes / 5)))}分`;
  const halves = Math.round(minutes / 30);
  if (halves >= 20) return `約${figure(Math.round(minutes / 60))}時間`;
  return `約${figure(Math.floor(halves / 2))}時間${halves % 2 === 1 ? '半' : ''}`;
}

function withoutNumber({ unnumbered }: EdgeList): string {
  return unnumbered === 0 ? '' : `番号のない辺${figure(unnumbered)}本`;
}

function startAndEnd({ edges, first, last }: EdgeList): string {
  if (edges < 2 || first === null) return '。';
  return last === null || last === first
    ? `。辺${first}から始めます。`
    : `。辺${first}から始め、最後は辺${last}です。`;
}

function close(list: EdgeList): string {
  const numbered = list.runs.length > 0 ? [`辺${list.runs.join('、')}`] : [];
  const rest = withoutNumber(list);
  const edges = [...numbered, ...(rest === '' ? [] : [rest])];
  return `${edges.join('と、')}を貼って閉じます${startAndEnd(list)}`;
}

function glue(list: Parameters<BuildingWords['glue']>[0]): string {
  const groups = list.groups.map(({ name, runs }) =>
    runs.length > 0 ? `部品${name}（辺${runs.join('、')}）` : `部品${name}`,
  );
  const places = `${groups.join('、次に')}に`;
  const rest = withoutNumber(list);
  if (list.unnumbered === list.edges) return `${rest}で${places}貼ります${startAndEnd(list)}`;
  return `${places}貼ります${rest && `。${rest}も貼ります`}${startAndEnd(list)}`;
}

function fold({ folds, crease, turn }: Parameters<BuildingWords['fold']>[0]): string {
  if (folds === 0) return '折り目はありません。';
  const own = creases[crease];
  if (turn === 0) {
    return folds === 1
      ? `1本の折り目を${own}にします。`
      : `${figure(folds)}本の折り目をすべて${own}にします。`;
  }
  const other = creases[crease === 'mountain' ? 'valley' : 'mountain'];
  return `${figure(folds)}本の折り目のうち、${figure(turn)}本を${other}に、残りをすべて${own}にします。`;
}

export const building: BuildingWords = {
  pageNote: ({ page, pages }) =>
    `組み立て説明 ${figure(page)}／${figure(pages)} · 見るためのページです（切りません）`,
  view: ({ name }) => views[name],
  sizeLabel: () => '完成サイズ',
  size: ({ width, height, depth }) => `幅${width} mm、高さ${height} mm、奥行き${depth} mm`,
  amountLabel: () => '切り取るもの',
  amount: ({ pieces, sheets, width, height }) =>
    `部品${figure(pieces)}個（${width} × ${height} mmのシート${figure(sheets)}枚）`,
  foldsLabel: () => '折るところ',
  folds: ({ mountains, valleys }) =>
    `${mountains === 0 ? '山折りなし' : `山折り${figure(mountains)}本`}、` +
    (valleys === 0 ? '谷折りなし' : `谷折り${figure(valleys)}本`),
  seamsLabel: () => '貼り合わせるところ',
  seams: ({ seams }) => `つなぎ目${figure(seams)}か所`,
  gluedLabel: () => 'のりを使う場合の時間',
  tapedLabel: () => 'テープを使う場合の時間',
  duration,
  mountain: () => '山折り：屋根のような形に折り、印刷した面が外側になります',
  valley: () => '谷折り：開いた本のような形に折り、印刷した面が内側になります',
  valleyPieces: ({ names, pieces, all: isAll }) => {
    if (pieces === 0) return '折り目はすべて山折りです。';
    if (isAll && pieces > 1) {
      return 'どの部品にも谷折りがあります。手順の図では青で示しています。';
    }
    if (isAll) return '手順の図では、谷折りを青で示しています。';
    const where = names.length > 0 ? all(names) : `${figure(pieces)}個の部品`;
    return `谷折りがあるのは${where}だけです。手順の図では青で示しています。`;
  },
  howTitle: () => '組み立て方',
  how: () => [
    '部品のシートは、厚めの紙（160～200 g/m²）に100%の大きさで印刷します。この説明のページは薄い紙でもかまいません。',
    '実線に沿って切ります。折り目はすべて、インクの出ないペンと定規でなぞって折り筋を付けてから折ります。',
    '同じ番号の辺どうしを貼り合わせます。手順の順番に進め、のりが乾いてから次の手順に移ります。',
  ],
  piecesTitle: () => '部品と、その場所',
  sheet: ({ sheet }) => `シート${figure(sheet)}`,
  faces: ({ faces, flaps }) => `面${figure(faces)}個、のりしろ${figure(flaps)}個`,
  pieceFolds: ({ folds, valleys }) => {
    if (folds === 0) return '折り目なし';
    const told = `折り目${figure(folds)}本`;
    if (valleys === 0) return `${told}、谷折りなし`;
    return valleys === folds ? `${told}、すべて谷折り` : `${told}、うち谷折り${figure(valleys)}本`;
  },
  hidden: () => 'ほかの部品に隠れているので、手前を透かして描いています',
  strips: ({ runs, strips }) =>
    `部品の横につなぎ紙が${figure(strips)}枚あります。辺${runs.join('、')}の裏に貼ります。`,
  stepsTitle: () => '手順',
  marks: ({ mark }) => marks[mark],
  stepTitle: ({ step, name }) => `手順${figure(step)}：部品${name}`,
  fold,
  close,
  glue,
  apart: () =>
    'この部品には、前の部品に貼る辺がありません。図のとおりの場所に置きます。まだ貼っていない番号があれば、' +
    'そこで同じ番号を探します。',
  finish: ({ last }) =>
    last === null
      ? 'これが最後の辺です。完成です。'
      : `辺${last}が、全体の最後の辺です。くっつくまで外側から押さえます。`,
};
