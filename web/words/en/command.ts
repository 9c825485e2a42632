/** What the command line says in English. */
import type { FileExcess } from '../../model/model-files.js';
import type { UsageFault } from '../command-faults.js';
import { count, figure } from './numbers.js';
import { excess } from './readers.js';

function usageFault(fault: UsageFault): string {
  switch (fault.what) {
    case 'unknown-option': {
      const { option, similar } = fault;
      if (similar.length === 0) return `unknown option '${option}'`;
      const which = similar.length > 1 ? `one of ${similar.join(', ')}` : similar[0];
      return `unknown option '${option}' (Did you mean ${which}?)`;
    }
    case 'no-argument':
      return `missing required argument '${fault.argument}'`;
    case 'no-value':
      return `option '${fault.option}' argument missing`;
    case 'too-many':
      return `too many arguments. Expected ${count(fault.wanted, 'argument')} but got ${figure(fault.given)}.`;
    case 'other':
      return fault.text;
  }
}

export const command = {
  usageFault,
  about: 'Unfolds a 3D model into paper nets.',
  usage: '[options] <model>',
  titles: { usage: 'Usage:', arguments: 'Arguments:', options: 'Options:' },
  withDefault: (text: string, value: string): string => `${text} (default: ${value})`,
  model:
    'OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO or FOLD file, or a folder or ZIP archive with one and what belongs to it; ' +
    'or a project (.foldwright), whose options hold unless others are given',
  output: (endings: string): string =>
    `write a file, as its ending says: ${endings}; may be given several times`,
  report: 'write a report as JSON',
  split:
    'split this part of what comes out, counted from 1, into k (2) parts; may be given several times',
  merge: 'merge these parts that touch; may be given several times',
  edits: 'then make these edits, a JSON list',
  name: 'at last name this part, counted from 1; may be given several times',
  manyModels: (help: string): string => `Many models at once: ${help}`,
  quiet: 'nothing on stderr but errors',
  version: 'output the version number',
  help: 'display help for command',

  note: (text: string): string => `note: ${text}`,
  internal: (text: string): string => `internal error: ${text}`,
  namedAlready: (part: number): string =>
    `option '--name': part ${figure(part)} has a name already`,
  namedTwice: (path: string): string => `'${path}' is named twice`,
  aboutName: (name: string, fault: string): string => `the name '${name}': ${fault}`,
  aboutEdit: (edit: number, fault: string): string => `edit ${figure(edit)}: ${fault}`,
  aboutProjectEdit: (edit: number, fault: string): string =>
    `edit ${figure(edit)} of the project: ${fault}`,
  aboutFile: (path: string, fault: string): string => `'${path}': ${fault}`,
  ending: (path: string, ending: string, known: string): string =>
    `'${path}': the ending '${ending}' is none of ${known}`,
  noJson: (path: string): string => `'${path}' is no JSON`,
  unreadable: (path: string): string => `'${path}' cannot be read`,
  isFolder: (path: string): string => `'${path}' is a directory`,
  noFolder: (path: string, folder: string): string =>
    `'${path}': the directory '${folder}' does not exist`,
  notAFolder: (path: string, folder: string): string =>
    `'${path}': the directory '${folder}' is not a directory`,
  notWritable: (path: string, folder: string, reason: string): string =>
    `'${path}': the directory '${folder}' cannot be written to (${reason})`,

  /** Why a model is not read, after its name. */
  noFile: 'there is no such file',
  notAllowed: 'may not be read',
  notRead: (reason: string): string => `cannot be read: ${reason}`,
  folderTooLarge: (fault: FileExcess): string => `the folder has ${excess(fault)}`,
  emptyFolder: 'there is no file in the folder',
  companionsTooLarge: (fault: FileExcess): string => `what belongs to it has ${excess(fault)}`,
  notAFile: 'is not a file',
  emptyFile: 'the file is empty',

  /** That an option was given for nothing. */
  idle: (option: string, without: string): string =>
    `option '--${option}' changes nothing without ${without}`,
  needs: {
    scale: "'--scale'",
    flaps: 'flaps',
    folding: 'folding',
    scissors: "'--machine none'",
    printer: "'--machine none' or '--machine silhouette'",
    output: (formats: readonly string[]): string =>
      formats.length > 1
        ? `a ${formats.slice(0, -1).join(', ')} or ${formats.at(-1)} file`
        : `a ${formats[0]} file`,
  },
  summary: (p: {
    name: string;
    faces: number;
    parts: number;
    pieces: number;
    sheets: number;
    size: string;
  }): string =>
    `${p.name}: ${count(p.faces, 'face')}, ${count(p.parts, 'part')}, ${count(p.pieces, 'piece')} ` +
    `on ${count(p.sheets, 'sheet')}, ${p.size}`,
};
