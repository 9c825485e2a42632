import type { Language } from '../model/languages.js';
import { english } from './en/index.js';
import type { Words } from './words.js';

/** English is there from the beginning; all others come when they are asked for. */
const sources: Readonly<Record<Language, () => Words | Promise<Words>>> = {
  en: () => english,
  de: async () => (await import('./de/index.js')).words,
  es: async () => (await import('./es/index.js')).words,
  fr: async () => (await import('./fr/index.js')).words,
  ja: async () => (await import('./ja/index.js')).words,
};

/** The words of a language, at once if they are there; else it rejects if they cannot be loaded. */
export function wordsOf(language: Language): Words | Promise<Words> {
  return sources[language]();
}

/** The same for those who wait anyway. */
export async function loadWords(language: Language): Promise<Words> {
  return wordsOf(language);
}
