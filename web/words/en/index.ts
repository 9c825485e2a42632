/** All English words: the pattern of every other language. */
import type { Language } from '../../model/languages.js';
import { batch } from './batch.js';
import { building } from './building.js';
import { check, choice, form, printing } from './choice.js';
import { command } from './command.js';
import { changes, edges, partWords, pieces } from './editing.js';
import { editsFault } from './edit-lists.js';
import { exhibit } from './exhibit.js';
import { folding, steps } from './folding.js';
import { keeping } from './keeping.js';
import { messages } from './messages.js';
import { speech } from './numbers.js';
import { optionHelp } from './option-help.js';
import { optionFault } from './options.js';
import { page, site } from './page.js';
import { repairSteps } from './repair.js';
import { replacing } from './replacing.js';
import { pictures, result, run } from './run.js';
import { samples } from './samples.js';
import { sheets } from './sheets.js';
import { verdict } from './verdict.js';

export const english = {
  /** As `lang` attributes have it. */
  code: 'en' as Language,
  speech,
  messages,
  unknown: (code: string): string => `message '${code}'`,
  optionFault,
  editsFault,

  batch,
  command,
  optionHelp,

  site,
  page,
  run,
  result,
  pictures,
  choice,
  check,
  exhibit,
  repairSteps,
  replacing,
  form,
  printing,
  samples,
  verdict,
  edges,
  pieces,
  parts: partWords,
  changes,
  folding,
  steps,
  keeping,

  sheets,
  building,
};
