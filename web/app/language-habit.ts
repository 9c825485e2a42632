/** The language that a person reads. */
import { languageOf, spokenOf, type Language } from '../model/languages.js';

/** Where the one that was chosen is kept from one visit to the next. */
const memory = 'foldwright.language';

function recalled(): Language | null {
  try {
    return languageOf(localStorage.getItem(memory) ?? '');
  } catch {
    // A browser that keeps nothing is no reason to fail.
    return null;
  }
}

/** The one that was chosen last, or else the first of the browser's that there is. */
export function personsLanguage(): Language {
  return recalled() ?? spokenOf(navigator.languages);
}

/** Remembers a choice for later visits. */
export function rememberLanguage(language: Language): void {
  try {
    localStorage.setItem(memory, language);
  } catch {
    // It is chosen again at the next visit.
  }
}
