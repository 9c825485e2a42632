/** The words of viewers, apart from all others: a page with a finished model loads no more. */
import type { Language } from '../model/languages.js';
import { viewer as english, type ViewerWords } from './en/viewer.js';

/** English is there from the beginning; all others come when they are asked for. */
const sources: Readonly<Record<Language, () => ViewerWords | Promise<ViewerWords>>> = {
  en: () => english,
  de: async () => (await import('./de/viewer.js')).viewer,
  es: async () => (await import('./es/viewer.js')).viewer,
  fr: async () => (await import('./fr/viewer.js')).viewer,
  ja: async () => (await import('./ja/viewer.js')).viewer,
};

/** The words of a language, at once if they are there; else it rejects if they cannot be loaded. */
export function viewerWordsOf(language: Language): ViewerWords | Promise<ViewerWords> {
  return sources[language]();
}
