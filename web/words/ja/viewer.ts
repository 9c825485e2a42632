/** What `<foldwright-viewer>` says in Japanese. */
import type { ViewerWords } from '../en/viewer.js';
import { figure } from './numbers.js';

export const viewer: ViewerWords = {
  unfold: '展開する',
  show: 'モデルを表示',
  cancel: 'キャンセル',
  play: '再生',
  pause: '一時停止',
  slider: '折った割合',
  percent: ({ share }) => `${figure(Math.floor(100 * share))}%`,
  flat: '平ら',
  folded: '折り終わり',
  foldedBy: ({ time }) => `${figure(Math.floor(100 * time))}%折ったところ`,
  downloads: 'ダウンロード',
  model: ({ name, pieces }) =>
    `${name}：${figure(pieces)}個の部品でできたペーパークラフト。矢印キーで回ります`,
  nets: ({ name, pieces }) => `${name}の展開図：切り取る部品は${figure(pieces)}個`,
  sheet: ({ sheet, sheets }) => `シート${figure(sheet)}／${figure(sheets)}`,
  noPicture: 'このブラウザーはモデルを3Dで表示できません。',
  faults: {
    'no-model': '展開するモデルがまだありません。',
    'not-loaded': 'モデルを読み込めません。',
    'not-fold': 'このFOLDファイルには、Foldwrightが書き出すモデルと展開図が入っていません。',
    'not-unfolded': 'モデルはまだ展開されていません。',
    'not-written': 'FOLDファイルからは書き出せません。先にモデルを展開してください。',
    removed: 'ビューアーはもうページにありません。',
  },
};
