/** What a verdict says in Japanese. */
import type { Remedy } from '../../model/remedies.js';
import type { Conclusion, FindingParams } from '../../model/verdict.js';
import type { FindingWords, VerdictWords } from '../verdict.js';
import { building } from './building.js';
import { all, figure, percentage, pieces } from './numbers.js';

/** A length in mm that is not told more exactly than it can be seen. */
function millimetres(mm: number): string {
  return `${figure(mm, mm < 10 ? 1 : 0)} mm`;
}

function unproved(found: FindingParams['unproved-folding'] & { count: number }): FindingWords {
  const { count, unchecked, pieces: names } = found;
  const hint =
    unchecked === count
      ? `${pieces(names)}の折り方は調べていません。三角形の少ない部品ほど折りやすくなります。`
      : `紙が紙を突き抜けずに${pieces(names)}を折る方法が見つかりませんでした。紙はたわむので、折れることもよくあります。`;
  return { title: `折りにくいかもしれない部品が${figure(count)}個あります`, hint };
}

const findings: VerdictWords['findings'] = {
  unfinished: {
    good: () => 'すべての三角形が部品に入っています',
    bad: ({ count }) => ({
      title: `どの部品にも入っていない三角形が${figure(count)}個あります`,
      hint: '探すのを早くやめすぎました。「展開する」をもう一度押して、最後まで待ってください。',
    }),
  },
  'run-stopped': {
    good: () => '最後まで探しました',
    bad: () => ({
      title: '探すのが途中で止められました',
      hint: '今あるもので作れます。最後まで探すと、もっと作りやすい展開図が見つかるかもしれません。',
    }),
  },
  'overlapping-pieces': {
    good: () => '自分自身と重なる部品はありません',
    bad: ({ count, pieces: names }) => ({
      title: `自分自身と重なる部品が${figure(count)}個あります`,
      hint: `${pieces(names)}は、そのままでは切り取れません。`,
    }),
  },
  'beyond-paper': {
    good: () => 'すべての部品がシートに入っています',
    bad: ({ count, pieces: names }) => ({
      title: `シートに入らない部品が${figure(count)}個あります`,
      hint: `プリンターで${pieces(names)}の端が切れてしまいます。`,
    }),
  },
  'short-seams': {
    good: () => '貼る辺は、指で持てる長さです',
    bad: ({ count, median_mm, isRed }) => ({
      title: `貼る辺のうち${figure(count)}本が短すぎます`,
      hint: `すべての辺の半分は長さ${millimetres(median_mm)}以下です。${
        isRed ? 'どんな指でも扱えない短さです。' : '指先には12 mm必要です。'
      }`,
    }),
  },
  'missing-flaps': {
    good: () => 'ほとんどの辺に、貼るためののりしろがあります',
    bad: ({ count, share }) => ({
      title: `のりしろのない辺が${figure(count)}本あります`,
      hint: `のりしろが必要な辺の${percentage(Math.round(100 * share))}です。内側からテープかつなぎ紙で留めます。`,
    }),
  },
  'missing-numbers': {
    good: () => 'どの辺どうしを貼るか、見てわかります',
    bad: ({ count }) => ({
      title: `読める番号のない辺が${figure(count)}本あります`,
      hint: 'どこと貼り合わせるかは、モデルを見て確かめてください。',
    }),
  },
  'missing-names': {
    good: () => 'どの部品にも名前が書いてあります',
    bad: ({ count, pieces: names }) => ({
      title: `名前の文字を書く場所がない部品が${figure(count)}個あります`,
      hint: `切り取るときに、${pieces(names)}の裏に書いてください。`,
    }),
  },
  'tiny-pieces': {
    good: () => '小さすぎる部品はありません',
    bad: ({ count, pieces: names }) => ({
      title: `10 mmより小さい部品が${figure(count)}個あります`,
      hint: `${pieces(names)}は最後に切り取ってください。小さい物はなくしやすいからです。`,
    }),
  },
  'weak-necks': {
    good: () => '細くつながっているだけの部品はありません',
    bad: ({ count, pieces: names }) => ({
      title: `細い所で破れそうな部品が${figure(count)}個あります`,
      hint: `折る前に、${pieces(names)}のその場所の裏にテープを貼ってください。`,
    }),
  },
  'unproved-folding': {
    good: () => 'どの部品も折れます。平らな状態から完成まで試しました',
    bad: unproved,
  },
  'spare-sheet': {
    good: ({ sheets }) =>
      sheets === 1 ? 'すべて1枚のシートに入っています' : 'シートをむだなく使っています',
    bad: ({ sheets, percent }) => ({
      title: '用紙を節約できます',
      hint:
        percent < 15
          ? `最後のシート（${figure(sheets)}枚目）は${percentage(percent)}しか使っていません。`
          : '少し小さくすると、シートの枚数が減ります。',
    }),
  },
  'long-building': {
    good: ({ seconds }) => `組み立てにかかる時間は${building.duration({ seconds })}です`,
    bad: ({ seconds }) => ({
      title: `組み立てにかかる時間は${building.duration({ seconds })}です`,
      hint: '何日かに分けて作るか、三角形を減らしてください。',
    }),
  },
};

/** The verdict in one line; `rows`: how many findings there are to look at. */
function headline({ code }: Conclusion, rows: number): string {
  switch (code) {
    case 'buildable':
      return '印刷できます';
    case 'hard':
      return `作れます。先に${figure(rows)}項目を確認してください`;
    case 'not-buildable':
      return 'まだ印刷しないでください。このままではだれにも作れません';
  }
}

/** How many rows there are at which all is well. */
function good(number: number): string {
  return `${figure(number)}項目は問題ありません`;
}

const shapes = { height: '高さ', width: '幅', depth: '奥行き' } as const;

/** What a button does that mends something. */
function remedy(remedy: Remedy): string {
  switch (remedy.kind) {
    case 'size': {
      const size = `${shapes[remedy.side]}を${figure(remedy.mm)} mmにする`;
      return remedy.saves > 0 ? `${size}（シートが${figure(remedy.saves)}枚減る）` : size;
    }
    case 'sheets':
      return `小さくしてシート${figure(remedy.sheets)}枚にする`;
    case 'faces':
      return `三角形を${figure(remedy.faces)}個にする`;
    case 'strips':
      return '裏に貼るつなぎ紙を付ける';
    case 'numbers-on-flaps':
      return '番号をのりしろに書く';
    case 'again':
      return remedy.names.length > 3
        ? `部品${figure(remedy.names.length)}個を探し直す`
        : `${all(remedy.names)}を探し直す`;
    case 'finish':
      return '最後まで展開し直す';
    case 'merge':
      return `${remedy.names.join('と')}をつなげる`;
  }
}

export const verdict: VerdictWords = {
  findings,
  levels: { green: '良好：', amber: '確認：', red: '注意：' },
  headline,
  good,
  remedy,
};
