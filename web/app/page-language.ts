/** The language of the page and of its studio. */
import { languageNames, languageOf, languages, type Language } from '../model/languages.js';
import { english } from '../words/en/index.js';
import { wordsOf } from '../words/load.js';
import type { Words } from '../words/words.js';
import { find, make } from './dom.js';
import { personsLanguage, rememberLanguage } from './language-habit.js';

/** The language that a person has chosen, or else the browser's, in the page and in its studio; with a field to choose another one. */
export class PageLanguage {
  private readonly list = find(document, '#language', HTMLSelectElement);
  private language = personsLanguage();
  /** Of the language that is chosen; English if they do not come. */
  words: Words = english;

  /** @param studio begins in the same language by itself, and follows every choice */
  constructor(
    private readonly studio: HTMLElement,
    private readonly onWords: (words: Words) => void,
  ) {
    this.list.append(
      ...languages.map((value) =>
        make('option', { value, textContent: languageNames[value], lang: value }),
      ),
    );
    this.list.addEventListener('change', () => {
      const chosen = languageOf(this.list.value);
      if (!chosen) return;
      rememberLanguage(chosen);
      this.speak(chosen);
    });
    this.speak(this.language);
  }

  private speak(language: Language): void {
    this.language = language;
    this.list.value = language;
    this.studio.lang = language;
    const words = wordsOf(language);
    if (!(words instanceof Promise)) return this.fill(words);
    void words
      .catch(() => english)
      .then((loaded) => {
        if (this.language === language) this.fill(loaded);
      });
  }

  private fill(words: Words): void {
    this.words = words;
    document.documentElement.lang = words.code;
    document.title = words.site.title;
    for (const element of document.querySelectorAll<HTMLElement>('[data-words]')) {
      element.textContent = words.site[element.dataset['words'] as keyof Words['site']];
    }
    this.onWords(words);
  }
}
