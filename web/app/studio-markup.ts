import { escaped } from '../model/markup.js';
import type { Words } from '../words/words.js';
import markup from './studio.html?raw';

/** What a key of the markup stands for, such as `start.choose`. */
function textAt(words: Words, key: string): string {
  if (key === 'code') return words.code;
  const [group = '', name = ''] = key.split('.');
  const texts = (words.page as Readonly<Record<string, Readonly<Record<string, string>>>>)[group];
  return texts?.[name] ?? key;
}

/** The markup of a studio in a language: `{{start.choose}}` there is a text of `Words.page`. */
export function studioMarkup(words: Words): string {
  return markup.replace(/\{\{([\w.]+)\}\}/g, (_, key: string) => escaped(textAt(words, key)));
}
