/** Languages that people can be spoken to in, by their codes (BCP 47), with their own names; the first one is the usual. */
export const languageNames = {
  en: 'English',
  de: 'Deutsch',
  es: 'Español',
  fr: 'Français',
  ja: '日本語',
} as const;

export type Language = keyof typeof languageNames;

export const languages = Object.keys(languageNames) as Language[];

/** Where nobody says another one. */
export const usualLanguage: Language = 'en';

/** The language of a code, which may name a region as well: that of `de-AT` is `de`. */
export function languageOf(code: string): Language | null {
  const [wanted] = code.toLowerCase().split('-');
  return languages.find((language) => language === wanted) ?? null;
}

/** The first of some languages that there is, the one most wished for first; the usual one if there is none. */
export function spokenOf(wishes: readonly string[]): Language {
  const found = wishes.map(languageOf).find((language) => language !== null);
  return found ?? usualLanguage;
}
