import type { Message } from '../model/message.js';
import { english } from './en/index.js';
import type { Words } from './words.js';

/** A message in words, as a phrase that may be part of a line. A code that is not known stands for itself. */
export function phraseOf({ messages, unknown }: Words, { code, params }: Message): string {
  const table = messages as unknown as Readonly<Record<string, (params: object) => string>>;
  try {
    const words = Object.hasOwn(table, code) ? table[code] : undefined;
    if (words) return words(params);
  } catch {
    // A message of another version, which lacks a parameter.
  }
  return unknown(code);
}

/** The same in English, for programs: their faults carry codes and parameters for all else. */
export function englishPhrase(message: Message): string {
  return phraseOf(english, message);
}

/** A repair as a message. */
export function repairPhrase(
  words: Words,
  { code, count, params }: Message & { count: number },
): string {
  return phraseOf(words, { code, params: { count, ...params } });
}
