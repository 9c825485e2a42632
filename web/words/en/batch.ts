/** What a batch says in English, on its page and in a terminal. */
import { building } from './building.js';
import { count, figure } from './numbers.js';

export const batch = {
  help: {
    about:
      'Unfolds many models. Killed and started again, it goes on where it was; what has changed since is done again.',
    usage: '[options] <source...>',
    source:
      'folder with models in it, at any depth; or a text file with a path in each line; or - for such a list on standard input; or models',
    out: 'folder for all that is written, and a page that shows it',
    format: (names: string): string => `some of ${names}, with commas between`,
    shard: 'only this share of the models, from 1/N to N/N: one for each of N machines',
    workers: 'In a batch --workers is the number of models at a time; auto: one per core.',
  },
  noFolder: (option: string): string => `option '${option}' is no folder`,
  noModels:
    'there is no model: no OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO or ZIP file, and no project',
  about: (name: string, text: string): string => `${name}: ${text}`,
  models: (models: number): string => count(models, 'model'),
  /** How many have come to what. */
  outcomes: {
    done: (models: number): string => `${figure(models)} done`,
    skipped: (models: number): string => `${figure(models)} done before`,
    refused: (models: number): string => `${figure(models)} not usable`,
    failed: (models: number): string => `${figure(models)} failed`,
    left: (models: number): string => `${figure(models)} not done yet`,
  },
  died: (reason: string): string => `the program could not go on with this model: ${reason}`,
  /** Why, if nothing else is known. */
  ended: (status: number): string => `the thread ended with status ${figure(status)}`,
  goOn: 'the same command goes on from here',

  pageTitle: 'Paper models',
  amount: ({ pieces, sheets }: { pieces: number; sheets: number }): string =>
    `${count(pieces, 'piece')} on ${count(sheets, 'sheet')}`,
  building: (seconds: number): string => `${building.duration({ seconds })} to build`,
  picture: (name: string): string => `${name}, folded`,
  notices: (notices: number): string => count(notices, 'note'),
  faults: 'These gave no paper model',
  missing: 'not done yet',
  failed: 'the program failed here and will try again the next time',
};
