/** English phrases for what is told of projects. */
import type { Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { choose, count, figure, some } from './numbers.js';

function badProject(params: Messages['bad-project']): string {
  const file = shown(params.file);
  if (params.what === 'newer') {
    return `'${file}' was saved by a newer Foldwright (its files have version ${figure(params.version)}); open it with that one`;
  }
  return `'${file}' is damaged: the model in it is lost; open an earlier copy of the project`;
}

function damagedProject(params: Messages['project-damaged']): string {
  switch (params.what) {
    case 'document':
      return 'the project file is damaged: only the model could be read from it, and none of the settings and changes';
    case 'files': {
      const are = choose(params.files.length, 'is', 'are');
      return `the project file is damaged: ${some(params.files)}, which ${are} part of the model, could not be read`;
    }
    case 'edits':
      return `the project file is damaged: the last ${count(params.count, 'change')} could not be read`;
    case 'refused':
      return `the last ${count(params.count, 'change')} of the project could not be made again with this model`;
  }
}

export const projectMessages = {
  'bad-project': badProject,
  'project-damaged': damagedProject,
  'project-options-lost': ({ options }) =>
    `${some(options)}: ${choose(options.length, 'this setting', 'these settings')} of the project ` +
    `${choose(options.length, 'is', 'are')} not known here, and stayed as usual`,
  'project-redrawn': () =>
    'the project was saved by another version of Foldwright: its pieces are the same, but small things, such as ' +
    'places of numbers, may differ from what was printed before',
} satisfies Partial<Table>;
