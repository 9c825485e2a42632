/** What the command line says in Spanish. */
import type { UsageFault } from '../command-faults.js';
import type { Words } from '../words.js';
import { counted, figure } from './numbers.js';
import { excess } from './readers.js';

function usageFault(fault: UsageFault): string {
  switch (fault.what) {
    case 'unknown-option': {
      const { option, similar } = fault;
      const hint = similar.length === 0 ? '' : ` (¿Querías decir ${similar.join(' o ')}?)`;
      return `opción desconocida '${option}'${hint}`;
    }
    case 'no-argument':
      return `falta el argumento '${fault.argument}'`;
    case 'no-value':
      return `falta el valor de la opción '${fault.option}'`;
    case 'too-many':
      return `demasiados argumentos: se esperaban ${figure(fault.wanted)} y hay ${figure(fault.given)}`;
    case 'other':
      return fault.text;
  }
}

export const command: Words['command'] = {
  usageFault,
  about: 'Despliega un modelo 3D en plantillas de papel.',
  usage: '[opciones] <model>',
  titles: { usage: 'Uso:', arguments: 'Argumentos:', options: 'Opciones:' },
  withDefault: (text, value) => `${text} (por defecto: ${value})`,
  model:
    'archivo OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO o FOLD, o una carpeta o archivo ZIP que tenga uno y lo que va con él; ' +
    'o un proyecto (.foldwright), cuyas opciones valen si no se dan otras',
  output: (endings) =>
    `escribir un archivo, según su extensión: ${endings}; se puede dar varias veces`,
  report: 'escribir un informe en JSON',
  split:
    'dividir esta parte del resultado, contando desde 1, en k (2) partes; se puede dar varias veces',
  merge: 'unir estas partes que se tocan; se puede dar varias veces',
  edits: 'después hacer estos cambios, una lista JSON',
  name: 'al final dar nombre a esta parte, contando desde 1; se puede dar varias veces',
  manyModels: (help) => `Muchos modelos a la vez: ${help}`,
  quiet: 'nada en stderr salvo errores',
  version: 'mostrar el número de versión',
  help: 'mostrar esta ayuda',

  note: (text) => `nota: ${text}`,
  internal: (text) => `error interno: ${text}`,
  namedAlready: (part) => `opción '--name': la parte ${figure(part)} ya tiene nombre`,
  namedTwice: (path) => `'${path}' aparece dos veces`,
  aboutName: (name, fault) => `el nombre '${name}': ${fault}`,
  aboutEdit: (edit, fault) => `cambio ${figure(edit)}: ${fault}`,
  aboutProjectEdit: (edit, fault) => `cambio ${figure(edit)} del proyecto: ${fault}`,
  aboutFile: (path, fault) => `'${path}': ${fault}`,
  ending: (path, ending, known) => `'${path}': la extensión '${ending}' no es ninguna de ${known}`,
  noJson: (path) => `'${path}' no es JSON`,
  unreadable: (path) => `'${path}' no se puede leer`,
  isFolder: (path) => `'${path}' es una carpeta`,
  noFolder: (path, folder) => `'${path}': la carpeta '${folder}' no existe`,
  notAFolder: (path, folder) => `'${path}': '${folder}' no es una carpeta`,
  notWritable: (path, folder, reason) =>
    `'${path}': no se puede escribir en la carpeta '${folder}' (${reason})`,

  noFile: 'no existe ese archivo',
  notAllowed: 'no está permitido leerlo',
  notRead: (reason) => `no se puede leer: ${reason}`,
  folderTooLarge: (fault) => `la carpeta tiene ${excess(fault)}`,
  emptyFolder: 'no hay ningún archivo en la carpeta',
  companionsTooLarge: (fault) => `lo que va con él tiene ${excess(fault)}`,
  notAFile: 'no es un archivo',
  emptyFile: 'el archivo está vacío',

  idle: (option, without) => `la opción '--${option}' no cambia nada sin ${without}`,
  needs: {
    scale: "'--scale'",
    flaps: 'pestañas',
    folding: 'plegado',
    scissors: "'--machine none'",
    printer: "'--machine none' o '--machine silhouette'",
    output: (formats) =>
      formats.length > 1
        ? `un archivo ${formats.slice(0, -1).join(', ')} o ${formats.at(-1)}`
        : `un archivo ${formats[0]}`,
  },
  summary: (p) =>
    `${p.name}: ${counted.faces(p.faces)}, ${counted.parts(p.parts)}, ${counted.pieces(p.pieces)} ` +
    `en ${counted.sheets(p.sheets)}, ${p.size}`,
};
