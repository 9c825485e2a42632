/** What the command line says in French. */
import type { UsageFault } from '../command-faults.js';
import type { Words } from '../words.js';
import { count, figure } from './numbers.js';
import { excess } from './readers.js';

function usageFault(fault: UsageFault): string {
  switch (fault.what) {
    case 'unknown-option': {
      const { option, similar } = fault;
      const hint = similar.length === 0 ? '' : ` (Tu veux dire ${similar.join(' ou ')}\u202f?)`;
      return `option inconnue '${option}'${hint}`;
    }
    case 'no-argument':
      return `il manque l’argument '${fault.argument}'`;
    case 'no-value':
      return `il manque la valeur de l’option '${fault.option}'`;
    case 'too-many':
      return `trop d’arguments\u202f: ${figure(fault.wanted)} attendus, ${figure(fault.given)} reçus`;
    case 'other':
      return fault.text;
  }
}

export const command: Words['command'] = {
  usageFault,
  about: 'Déplie un modèle 3D en patrons de papier.',
  usage: '[options] <model>',
  titles: { usage: 'Utilisation\u202f:', arguments: 'Arguments\u202f:', options: 'Options\u202f:' },
  withDefault: (text, value) => `${text} (par défaut\u202f: ${value})`,
  model:
    'fichier OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO ou FOLD, ou un dossier ou une archive ZIP qui en contient un et ce qui va avec\u202f; ' +
    'ou un projet (.foldwright), dont les options valent sauf si d’autres sont données',
  output: (endings) =>
    `écrire un fichier, selon sa terminaison\u202f: ${endings}\u202f; peut être donnée plusieurs fois`,
  report: 'écrire un rapport en JSON',
  split:
    'diviser cette partie du résultat, comptée à partir de 1, en k (2) parties\u202f; peut être donnée plusieurs fois',
  merge: 'réunir ces parties qui se touchent\u202f; peut être donnée plusieurs fois',
  edits: 'faire ensuite ces modifications, une liste JSON',
  name: 'à la fin, nommer cette partie, comptée à partir de 1\u202f; peut être donnée plusieurs fois',
  manyModels: (help) => `Beaucoup de modèles à la fois\u202f: ${help}`,
  quiet: 'rien que les erreurs sur stderr',
  version: 'afficher le numéro de version',
  help: 'afficher cette aide',

  note: (text) => `remarque\u202f: ${text}`,
  internal: (text) => `erreur interne\u202f: ${text}`,
  namedAlready: (part) => `option '--name'\u202f: la partie ${figure(part)} a déjà un nom`,
  namedTwice: (path) => `'${path}' est nommé deux fois`,
  aboutName: (name, fault) => `le nom '${name}'\u202f: ${fault}`,
  aboutEdit: (edit, fault) => `modification ${figure(edit)}\u202f: ${fault}`,
  aboutProjectEdit: (edit, fault) => `modification ${figure(edit)} du projet\u202f: ${fault}`,
  aboutFile: (path, fault) => `'${path}'\u202f: ${fault}`,
  ending: (path, ending, known) =>
    `'${path}'\u202f: la terminaison '${ending}' ne fait pas partie de ${known}`,
  noJson: (path) => `'${path}' n’est pas du JSON`,
  unreadable: (path) => `impossible de lire '${path}'`,
  isFolder: (path) => `'${path}' est un dossier`,
  noFolder: (path, folder) => `'${path}'\u202f: le dossier '${folder}' n’existe pas`,
  notAFolder: (path, folder) => `'${path}'\u202f: '${folder}' n’est pas un dossier`,
  notWritable: (path, folder, reason) =>
    `'${path}'\u202f: impossible d’écrire dans le dossier '${folder}' (${reason})`,

  noFile: 'ce fichier n’existe pas',
  notAllowed: 'la lecture n’est pas permise',
  notRead: (reason) => `impossible de le lire\u202f: ${reason}`,
  folderTooLarge: (fault) => `dans le dossier, il y a ${excess(fault)}`,
  emptyFolder: 'il n’y a pas de fichier dans le dossier',
  companionsTooLarge: (fault) => `dans ce qui va avec, il y a ${excess(fault)}`,
  notAFile: 'ce n’est pas un fichier',
  emptyFile: 'le fichier est vide',

  idle: (option, without) => `l’option '--${option}' ne change rien sans ${without}`,
  needs: {
    scale: "'--scale'",
    flaps: 'languettes',
    folding: 'pliage',
    scissors: "'--machine none'",
    printer: "'--machine none' ou '--machine silhouette'",
    output: (formats) =>
      formats.length > 1
        ? `un fichier ${formats.slice(0, -1).join(', ')} ou ${formats.at(-1)}`
        : `un fichier ${formats[0]}`,
  },
  summary: (p) =>
    `${p.name}\u202f: ${count(p.faces, 'face', 'faces')}, ${count(p.parts, 'partie', 'parties')}, ` +
    `${count(p.pieces, 'pièce', 'pièces')} sur ${count(p.sheets, 'feuille', 'feuilles')}, ${p.size}`,
};
