/** What the studio says in Japanese of the work that a browser keeps. */
import type { Words } from '../words.js';
import { figure } from './numbers.js';

const quoted = (name: string): string => `「${name}」`;

const relative = new Intl.RelativeTimeFormat('ja', { numeric: 'auto' });

export const keeping: Words['keeping'] = {
  goOn: (name, isPending) =>
    isPending ? `${quoted(name)}をもう一度展開する` : `${quoted(name)}の続きをする`,
  ago: (number, unit) => relative.format(-number, unit),
  justNow: 'たった今',
  showAll: (number) => `${figure(number)}個すべてを表示`,
  rename: '名前を変える',
  copy: 'コピー',
  remove: '削除',
  about: (word, name) => `${quoted(name)}：${word}`,
  newName: (name) => `${quoted(name)}の新しい名前`,
  kept: 'このブラウザーに保存しています。ほかの場所でも使うには、プロジェクトをダウンロードしてください。',
  none: 'このブラウザーは、このページの作品を保存しません。離れる前にプロジェクトをダウンロードしてください。',
  scarce:
    'この端末の空き容量が少なくなっています。古い作品を削除するか、離れる前にプロジェクトをダウンロードしてください。',
  unfinished: '未完成',
  deleted: (name) => `${quoted(name)}を削除しました。`,
  copyOf: (name) => `${name}のコピー`,
  full: [
    '最後の変更が保存されていません',
    'この端末に空き容量がありません。なくさないように、最初のページで古い作品を削除するか、プロジェクトをダウンロードしてください。',
  ],
  lost: [
    '作品が保存されていません',
    'このブラウザーは、このページの作品を保存しません。なくさないように、離れる前にプロジェクトをダウンロードしてください。',
  ],
  copied: (name) => [
    'この作品は、別のページでも変更されました',
    `両方とも残しました。ここに見えている作品は${quoted(name)}として続けられます。`,
  ],
  deletedElsewhere: (name) => [
    `${quoted(name)}は、別のページで消されました`,
    'ここに見えている作品は、もう保存されていません。なくならないように残してください。',
  ],
  keepIt: '残す',
  gone: (name) => `${quoted(name)}はもうありません。`,
};
