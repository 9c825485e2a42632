/** What a batch says in Spanish, on its page and in a terminal. */
import type { Words } from '../words.js';
import { building } from './building.js';
import { count, figure } from './numbers.js';

export const batch: Words['batch'] = {
  help: {
    about:
      'Despliega muchos modelos. Si se detiene y se vuelve a iniciar, sigue donde estaba; lo que ha cambiado desde entonces se hace de nuevo.',
    usage: '[opciones] <fuente...>',
    source:
      'carpeta con modelos, también en subcarpetas; o un archivo de texto con una ruta en cada línea; o - para una lista así por la entrada estándar; o modelos',
    out: 'carpeta para todo lo que se escribe, con una página que lo muestra',
    format: (names) => `algunos de ${names}, separados por comas`,
    shard: 'solo esta parte de los modelos, de 1/N a N/N: una para cada uno de N ordenadores',
    workers:
      'Con muchos modelos, --workers es el número de modelos a la vez; auto: uno por núcleo.',
  },
  noFolder: (option) => `la opción '${option}' no es una carpeta`,
  noModels:
    'no hay ningún modelo: ningún archivo OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO o ZIP, y ningún proyecto',
  about: (name, text) => `${name}: ${text}`,
  models: (models) => count(models, 'modelo', 'modelos'),
  outcomes: {
    done: (models) => count(models, 'listo', 'listos'),
    skipped: (models) => count(models, 'listo de antes', 'listos de antes'),
    refused: (models) => count(models, 'no sirve', 'no sirven'),
    failed: (models) => count(models, 'fallido', 'fallidos'),
    left: (models) => count(models, 'sin hacer todavía', 'sin hacer todavía'),
  },
  died: (reason) => `el programa no pudo seguir con este modelo: ${reason}`,
  ended: (status) => `el hilo terminó con el estado ${figure(status)}`,
  goOn: 'la misma orden sigue desde aquí',

  pageTitle: 'Modelos de papel',
  amount: ({ pieces, sheets }) =>
    `${count(pieces, 'pieza', 'piezas')} en ${count(sheets, 'hoja', 'hojas')}`,
  building: (seconds) => `${building.duration({ seconds })} para montarlo`,
  picture: (name) => `${name}, plegado`,
  notices: (notices) => count(notices, 'nota', 'notas'),
  faults: 'De estos no salió ningún modelo de papel',
  missing: 'sin hacer todavía',
  failed: 'aquí falló el programa; la próxima vez lo intentará de nuevo',
};
