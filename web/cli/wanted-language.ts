import { languageOf, usualLanguage, type Language } from '../model/languages.js';

/** The language that a command line asks for, which is needed before it is read; one that there is not is refused then. */
export function wantedLanguage(args: readonly string[]): Language {
  const codes = args.flatMap((arg, i) => {
    if (arg.startsWith('--lang=')) return [arg.slice('--lang='.length)];
    return arg === '--lang' ? (args[i + 1] ?? []) : [];
  });
  return languageOf(codes.at(-1) ?? '') ?? usualLanguage;
}
