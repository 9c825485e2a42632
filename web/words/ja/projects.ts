/** Japanese phrases for what is told of projects. */
import type { Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { figure, some } from './numbers.js';

function badProject(params: Messages['bad-project']): string {
  const file = shown(params.file);
  if (params.what === 'newer') {
    return `'${file}'は、もっと新しいFoldwrightで保存されています（ファイルのバージョン${figure(params.version)}）。そのFoldwrightで開いてください`;
  }
  return `'${file}'は壊れていて、中のモデルが失われています。プロジェクトの以前のコピーを開いてください`;
}

function damagedProject(params: Messages['project-damaged']): string {
  switch (params.what) {
    case 'document':
      return 'プロジェクトのファイルが壊れています。モデルだけを読み込み、設定と変更は読めませんでした';
    case 'files':
      return `プロジェクトのファイルが壊れています。モデルの一部である${some(params.files)}を読めませんでした`;
    case 'edits':
      return `プロジェクトのファイルが壊れています。最後の${figure(params.count)}個の変更を読めませんでした`;
    case 'refused':
      return `プロジェクトの最後の${figure(params.count)}個の変更は、このモデルではやり直せませんでした`;
  }
}

export const projectMessages = {
  'bad-project': badProject,
  'project-damaged': damagedProject,
  'project-options-lost': ({ options }) =>
    `${some(options)}：プロジェクトのこの設定はここでは使えないので、ふだんの値のままです`,
  'project-redrawn': () =>
    'このプロジェクトは別のバージョンのFoldwrightで保存されました。部品は同じですが、番号の場所など、' +
    '前に印刷したものと細かいところが違うかもしれません',
} satisfies Partial<Table>;
