/** What the studio says in English of the work that a browser keeps. */
import { figure } from './numbers.js';

const quoted = (name: string): string => `“${name}”`;

const relative = new Intl.RelativeTimeFormat('en', { numeric: 'auto' });

export const keeping = {
  /** What one press of a button goes on with. */
  goOn: (name: string, isPending: boolean): string =>
    isPending ? `Unfold ${quoted(name)} again` : `Go on with ${quoted(name)}`,
  ago: (number: number, unit: Intl.RelativeTimeFormatUnit): string =>
    relative.format(-number, unit),
  justNow: 'just now',
  showAll: (number: number): string => `Show all ${figure(number)}`,
  rename: 'Rename',
  copy: 'Copy',
  remove: 'Delete',
  /** A button's word with what it is about. */
  about: (word: string, name: string): string => `${word} ${quoted(name)}`,
  newName: (name: string): string => `New name of ${quoted(name)}`,
  kept: 'Kept in this browser. To have it elsewhere too, download the project.',
  none: 'This browser keeps nothing for this page. Download the project before you leave.',
  scarce:
    'There is little room left on this device. Delete old work, or download the project before you leave.',
  unfinished: 'not finished',
  deleted: (name: string): string => `${quoted(name)} was deleted.`,
  copyOf: (name: string): string => `Copy of ${name}`,
  full: [
    'Your last changes are not kept',
    'There is no room left on this device. Delete old work on the start page, or download the project, so that nothing is lost.',
  ] as [string, string],
  lost: [
    'Your work is not kept',
    'This browser keeps nothing for this page. Download the project before you leave, so that nothing is lost.',
  ] as [string, string],
  copied: (name: string): [string, string] => [
    'This work was changed on another page, too',
    `Both are kept: what you see here goes on as ${quoted(name)}.`,
  ],
  /** Of work that is open here: what happened, and what can be done. */
  deletedElsewhere: (name: string): [string, string] => [
    `${quoted(name)} was deleted on another page`,
    'What you see here is not kept any more. Keep it, so that nothing is lost.',
  ],
  keepIt: 'Keep it',
  gone: (name: string): string => `${quoted(name)} is not there any more.`,
};
