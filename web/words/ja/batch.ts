/** What a batch says in Japanese, on its page and in a terminal. */
import type { Words } from '../words.js';
import { building } from './building.js';
import { figure } from './numbers.js';

export const batch: Words['batch'] = {
  help: {
    about:
      'たくさんのモデルを展開します。途中で止めても、もう一度始めれば続きから進みます。その間に変わったものは作り直します。',
    usage: '[オプション] <入力...>',
    source:
      'モデルの入ったフォルダー（下のフォルダーも含む）、1行に1つのパスを書いたテキストファイル、標準入力から読むリスト（-）、またはモデル',
    out: '書き出すファイルとその一覧ページを入れるフォルダー',
    format: (names) => `${names}から選び、コンマで区切る`,
    shard: 'モデルのうちこの分だけ（1/NからN/Nまで）。N台のコンピューターに1つずつ',
    workers: 'たくさんのモデルでは、--workersは同時に進めるモデルの数です。auto：コア1つに1つ。',
  },
  noFolder: (option) => `オプション'${option}'はフォルダーではありません`,
  noModels:
    'モデルがありません。OBJ、STL、OFF、PLY、GLB、glTF、3MF、PDO、ZIPのファイルも、プロジェクトも見つかりません',
  about: (name, text) => `${name}：${text}`,
  models: (models) => `モデル${figure(models)}個`,
  outcomes: {
    done: (models) => `完了${figure(models)}個`,
    skipped: (models) => `前に完了${figure(models)}個`,
    refused: (models) => `使えない${figure(models)}個`,
    failed: (models) => `失敗${figure(models)}個`,
    left: (models) => `まだ${figure(models)}個`,
  },
  died: (reason) => `このモデルの処理を続けられませんでした：${reason}`,
  ended: (status) => `スレッドが状態${figure(status)}で終わりました`,
  goOn: '同じコマンドでここから続けられます',

  pageTitle: '紙のモデル',
  amount: ({ pieces, sheets }) => `部品${figure(pieces)}個、シート${figure(sheets)}枚`,
  building: (seconds) => `組み立てに${building.duration({ seconds })}`,
  picture: (name) => `折りたたんだ${name}`,
  notices: (notices) => `メモ${figure(notices)}件`,
  faults: '紙のモデルにならなかったもの',
  missing: 'まだできていません',
  failed: 'ここでプログラムが失敗しました。次にもう一度試します',
};
