/** Spanish phrases for what is told of projects. */
import type { Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { choose, figure, some } from './numbers.js';

function badProject(params: Messages['bad-project']): string {
  const file = shown(params.file);
  if (params.what === 'newer') {
    return `'${file}' se guardó con un Foldwright más nuevo (sus archivos son de la versión ${figure(params.version)}); ábrelo con ese`;
  }
  return `'${file}' está dañado: el modelo que contiene se ha perdido; abre una copia anterior del proyecto`;
}

const lastChanges = (number: number): string =>
  number === 1 ? 'el último cambio' : `los ${figure(number)} últimos cambios`;

function damagedProject(params: Messages['project-damaged']): string {
  switch (params.what) {
    case 'document':
      return 'el archivo del proyecto está dañado: solo se pudo leer el modelo, y ninguno de los ajustes y cambios';
    case 'files': {
      const lost = choose(
        params.files.length,
        'que es parte del modelo, no se pudo',
        'que son parte del modelo, no se pudieron',
      );
      return `el archivo del proyecto está dañado: ${some(params.files)}, ${lost} leer`;
    }
    case 'edits':
      return `el archivo del proyecto está dañado: ${choose(params.count, 'no se pudo', 'no se pudieron')} leer ${lastChanges(params.count)}`;
    case 'refused':
      return `${choose(params.count, 'no se pudo', 'no se pudieron')} repetir con este modelo ${lastChanges(params.count)} del proyecto`;
  }
}

export const projectMessages = {
  'bad-project': badProject,
  'project-damaged': damagedProject,
  'project-options-lost': ({ options }) =>
    `${some(options)}: ${choose(
      options.length,
      'este ajuste del proyecto no se conoce aquí y quedó como siempre',
      'estos ajustes del proyecto no se conocen aquí y quedaron como siempre',
    )}`,
  'project-redrawn': () =>
    'el proyecto se guardó con otra versión de Foldwright: sus piezas son las mismas, pero algunas cosas pequeñas, ' +
    'como el sitio de los números, pueden ser distintas de lo que se imprimió antes',
} satisfies Partial<Table>;
