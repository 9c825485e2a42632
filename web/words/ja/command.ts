/** What the command line says in Japanese. */
import type { UsageFault } from '../command-faults.js';
import type { Words } from '../words.js';
import { figure } from './numbers.js';
import { excess } from './readers.js';

function usageFault(fault: UsageFault): string {
  switch (fault.what) {
    case 'unknown-option': {
      const { option, similar } = fault;
      const hint = similar.length === 0 ? '' : `（${similar.join('、')}のことですか？）`;
      return `オプション'${option}'はありません${hint}`;
    }
    case 'no-argument':
      return `引数'${fault.argument}'が必要です`;
    case 'no-value':
      return `オプション'${fault.option}'の値がありません`;
    case 'too-many':
      return `引数が多すぎます。${figure(fault.wanted)}個のはずが、${figure(fault.given)}個あります`;
    case 'other':
      return fault.text;
  }
}

export const command: Words['command'] = {
  usageFault,
  about: '3Dモデルを紙の展開図にします。',
  usage: '[オプション] <model>',
  titles: { usage: '使い方：', arguments: '引数：', options: 'オプション：' },
  withDefault: (text, value) => `${text}（初期値：${value}）`,
  model:
    'OBJ、STL、OFF、PLY、GLB、glTF、3MF、PDO、FOLDのファイル、またはそれと必要なものが入ったフォルダーかZIP。' +
    'プロジェクト（.foldwright）なら、ほかに指定しないかぎりその設定を使います',
  output: (endings) => `拡張子に応じたファイルを書き出します：${endings}。何度でも指定できます`,
  report: 'レポートをJSONで書き出します',
  split:
    '結果のブロック（1から数えます）をk個（初期値2）のブロックに分けます。何度でも指定できます',
  merge: '隣り合うブロックをまとめます。何度でも指定できます',
  edits: '続けてこの編集を行います。JSONのリストです',
  name: '最後にブロック（1から数えます）に名前を付けます。何度でも指定できます',
  manyModels: (help) => `たくさんのモデルを一度に：${help}`,
  quiet: 'stderrにはエラーだけを出します',
  version: 'バージョン番号を表示します',
  help: 'この使い方を表示します',

  note: (text) => `お知らせ：${text}`,
  internal: (text) => `内部エラー：${text}`,
  namedAlready: (part) => `オプション'--name'：ブロック${figure(part)}にはもう名前があります`,
  namedTwice: (path) => `'${path}'が2回指定されています`,
  aboutName: (name, fault) => `名前'${name}'：${fault}`,
  aboutEdit: (edit, fault) => `編集${figure(edit)}：${fault}`,
  aboutProjectEdit: (edit, fault) => `プロジェクトの編集${figure(edit)}：${fault}`,
  aboutFile: (path, fault) => `'${path}'：${fault}`,
  ending: (path, ending, known) =>
    `'${path}'：拡張子'${ending}'は使えません。使えるのは${known}です`,
  noJson: (path) => `'${path}'はJSONではありません`,
  unreadable: (path) => `'${path}'を読めません`,
  isFolder: (path) => `'${path}'はフォルダーです`,
  noFolder: (path, folder) => `'${path}'：フォルダー'${folder}'がありません`,
  notAFolder: (path, folder) => `'${path}'：'${folder}'はフォルダーではありません`,
  notWritable: (path, folder, reason) =>
    `'${path}'：フォルダー'${folder}'に書き込めません（${reason}）`,

  noFile: 'そのようなファイルはありません',
  notAllowed: '読むことが許可されていません',
  notRead: (reason) => `読めません：${reason}`,
  folderTooLarge: (fault) => `フォルダーが大きすぎます。${excess(fault)}`,
  emptyFolder: 'フォルダーにファイルがありません',
  companionsTooLarge: (fault) => `モデルに必要なものが大きすぎます。${excess(fault)}`,
  notAFile: 'ファイルではありません',
  emptyFile: 'ファイルが空です',

  idle: (option, without) =>
    `オプション'--${option}'を指定しても、${without}がないと何も変わりません`,
  needs: {
    scale: "'--scale'",
    flaps: 'のりしろ',
    folding: '折り方の確認',
    scissors: "'--machine none'",
    printer: "'--machine none'か'--machine silhouette'",
    output: (formats) => `${formats.join('か')}のファイル`,
  },
  summary: (p) =>
    `${p.name}：面${figure(p.faces)}個、ブロック${figure(p.parts)}個、部品${figure(p.pieces)}個、` +
    `シート${figure(p.sheets)}枚、${p.size}`,
};
