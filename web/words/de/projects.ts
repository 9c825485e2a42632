/** German phrases for what is told of projects. */
import type { Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { choose, count, figure, some } from './numbers.js';

function badProject(params: Messages['bad-project']): string {
  const file = shown(params.file);
  if (params.what === 'newer') {
    return `'${file}' wurde von einem neueren Foldwright gespeichert (seine Dateien haben die Version ${figure(params.version)}); öffne es mit diesem`;
  }
  return `'${file}' ist beschädigt: Das Modell darin ist verloren; öffne eine frühere Kopie des Projekts`;
}

const changes = (number: number): string =>
  number === 1 ? 'die letzte Änderung' : `die letzten ${figure(number)} Änderungen`;

function damagedProject(params: Messages['project-damaged']): string {
  switch (params.what) {
    case 'document':
      return 'die Projektdatei ist beschädigt: Nur das Modell ließ sich daraus lesen, und keine der Einstellungen und Änderungen';
    case 'files': {
      const parted = choose(
        params.files.length,
        'das zum Modell gehört, ließ',
        'die zum Modell gehören, ließen',
      );
      return `die Projektdatei ist beschädigt: ${some(params.files)}, ${parted} sich nicht lesen`;
    }
    case 'edits':
      return `die Projektdatei ist beschädigt: ${changes(params.count)} ${choose(params.count, 'ließ', 'ließen')} sich nicht lesen`;
    case 'refused':
      return `${changes(params.count)} des Projekts ${choose(params.count, 'ließ', 'ließen')} sich mit diesem Modell nicht wiederholen`;
  }
}

export const projectMessages = {
  'bad-project': badProject,
  'project-damaged': damagedProject,
  'project-options-lost': ({ options }) =>
    `${some(options)}: ${count(options.length, 'Einstellung', 'Einstellungen')} des Projekts ` +
    `${choose(options.length, 'ist hier nicht bekannt und blieb', 'sind hier nicht bekannt und blieben')} wie üblich`,
  'project-redrawn': () =>
    'das Projekt wurde von einer anderen Version von Foldwright gespeichert: Seine Teile sind dieselben, aber kleine Dinge, ' +
    'wie die Plätze von Nummern, können anders sein als auf früheren Ausdrucken',
} satisfies Partial<Table>;
