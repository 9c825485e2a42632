import type { Message } from '../model/message.js';
import { english } from './en.js';

const table = english as unknown as Readonly<Record<string, (params: object) => string>>;

/** A message in words, as a phrase that may be part of a line. A code that is not known stands for itself. */
export function phraseOf({ code, params }: Message): string {
  try {
    const words = Object.hasOwn(table, code) ? table[code] : undefined;
    if (words) return words(params);
  } catch {
    // A message of another version, which lacks a parameter.
  }
  return `message '${code}'`;
}

/** A repair as a message. */
export function repairPhrase({ code, count, params }: Message & { count: number }): string {
  return phraseOf({ code, params: { count, ...params } });
}
