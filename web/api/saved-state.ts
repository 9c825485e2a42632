/** States of documents as projects keep them. */
import { echo, type Settings } from '../model/options.js';
import type { SavedState, WrittenSettings } from '../project/project.js';
import { BadOption } from '../words/bad-option.js';
import type { DocumentState, Wishes } from './document-state.js';
import { changedSettings, defaultSettings } from './written-options.js';

/** Options of the device, its printer and who reads, which are in no project. */
const ofDevice: readonly string[] = ['workers', 'measured', 'lang'];

/** Messages of a project about itself begin like this. */
const aboutProject = 'project-';

/** The settings that belong to a document, by the command line's names. */
export function savedSettings(settings: Settings): WrittenSettings {
  const entries = Object.entries(echo(settings)).filter(([name]) => !ofDevice.includes(name));
  return Object.fromEntries(entries);
}

/** Settings as they were saved, and the names of those that make no sense here. */
export function readSettings(options: WrittenSettings): { settings: Settings; lost: string[] } {
  const own = Object.entries(options).filter(([name]) => !ofDevice.includes(name));
  let settings = defaultSettings();
  const lost: string[] = [];
  // The paper first: whether a margin leaves any room depends on it.
  const rank = ([name]: [string, unknown]): number => (name === 'paper' ? 0 : 1);
  for (const [name, value] of own.sort((a, b) => rank(a) - rank(b))) {
    try {
      settings = changedSettings(settings, { [name]: value });
    } catch (error) {
      if (!(error instanceof BadOption)) throw error;
      lost.push(name);
    }
  }
  return { settings, lost };
}

/** A state as it is kept. */
export function savedState({ wishes, result, start, isStopped }: DocumentState): SavedState {
  const { settings, flapEdges, locks, names, pins } = wishes;
  const { labels, nets, paper } = start;
  const { hash, search, seconds } = result;
  const notices = result.notices.filter(({ code }) => !code.startsWith(aboutProject));
  return {
    hash,
    options: savedSettings(settings),
    flapEdges,
    locks,
    names,
    pins,
    start: { labels, nets, paper },
    told: { search, seconds, notices },
    ...(isStopped && { isStopped }),
  };
}

/** What was asked for in a state that was kept. */
export function savedWishes({ options, flapEdges, locks, names, pins }: SavedState): Wishes {
  return { settings: readSettings(options).settings, flapEdges, locks, names, pins };
}
