/** French phrases for what is told of projects. */
import type { Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { choose, figure, some } from './numbers.js';

function badProject(params: Messages['bad-project']): string {
  const file = shown(params.file);
  if (params.what === 'newer') {
    return `'${file}' a été enregistré par un Foldwright plus récent (ses fichiers ont la version ${figure(params.version)})\u202f; ouvre-le avec celui-là`;
  }
  return `'${file}' est abîmé\u202f: le modèle qu’il contient est perdu\u202f; ouvre une copie plus ancienne du projet`;
}

/** "la dernière modification", "les 3 dernières modifications" */
function lastChanges(number: number): string {
  return number === 1
    ? 'la dernière modification'
    : `les ${figure(number)} dernières modifications`;
}

function damagedProject(params: Messages['project-damaged']): string {
  switch (params.what) {
    case 'document':
      return 'le fichier du projet est abîmé\u202f: on n’a pu y lire que le modèle, et aucun des réglages ni aucune des modifications';
    case 'files': {
      const unread = choose(
        params.files.length,
        'qui fait partie du modèle, n’a pas pu être lu',
        'qui font partie du modèle, n’ont pas pu être lus',
      );
      return `le fichier du projet est abîmé\u202f: ${some(params.files)}, ${unread}`;
    }
    case 'edits':
      return `le fichier du projet est abîmé\u202f: ${lastChanges(params.count)} ${choose(params.count, 'n’a pas pu être lue', 'n’ont pas pu être lues')}`;
    case 'refused':
      return `${lastChanges(params.count)} du projet ${choose(params.count, 'n’a pas pu être refaite', 'n’ont pas pu être refaites')} avec ce modèle`;
  }
}

export const projectMessages = {
  'bad-project': badProject,
  'project-damaged': damagedProject,
  'project-options-lost': ({ options }) =>
    `${some(options)}\u202f: ${choose(
      options.length,
      'ce réglage du projet est inconnu ici et garde sa valeur habituelle',
      'ces réglages du projet sont inconnus ici et gardent leurs valeurs habituelles',
    )}`,
  'project-redrawn': () =>
    'le projet a été enregistré par une autre version de Foldwright\u202f: ses pièces sont les mêmes, mais de petites choses, comme ' +
    'la place des numéros, peuvent être différentes de ce qui a été imprimé avant',
} satisfies Partial<Table>;
