/** The tables of all languages beside the English one. */
import { describe, expect, it } from 'vitest';
import { languageOf, languages, spokenOf, type Language } from '../../web/model/languages.js';
import type { MessageParams } from '../../web/model/message.js';
import { english } from '../../web/words/en/index.js';
import { viewer } from '../../web/words/en/viewer.js';
import { loadWords } from '../../web/words/load.js';
import { phraseOf } from '../../web/words/phrase.js';
import { speechOf } from '../../web/words/speech.js';
import { viewerWordsOf } from '../../web/words/viewer-words.js';
import { examples } from './message-examples.js';

/** What is the same in another language: names, and words that both have. */
const same: Readonly<Record<string, readonly string[]>> = {
  de: [
    'command.needs.scale',
    'command.needs.scissors',
    'page.piece.name',
    'page.settings.auto',
    'result.minutes',
    'samples.torus',
  ],
  es: [
    'command.needs.scale',
    'command.needs.scissors',
    'form.scale',
    'page.settings.auto',
    'result.minutes',
  ],
  fr: [
    'batch.help.usage',
    'command.needs.scale',
    'command.needs.scissors',
    'command.usage',
    'page.check.triangles',
    'page.print.pages',
    'page.settings.auto',
    'result.facts.triangles',
    'result.minutes',
    'samples.cube',
  ],
  ja: ['command.needs.scale', 'command.needs.scissors'],
};

/** All texts and functions of a table, by their paths in it. */
function entriesOf(table: object, prefix = ''): [path: string, value: unknown][] {
  return Object.entries(table).flatMap(([key, value]) =>
    typeof value === 'object' && value !== null
      ? entriesOf(value as object, `${prefix}${key}.`)
      : [[prefix + key, value] as [string, unknown]],
  );
}

/** What stands in the source of a function between quotes, which is what it says. */
function saidBy(value: unknown): string {
  if (typeof value !== 'function') return String(value);
  return (String(value).match(/'[^']*'|`[^`]*`|"[^"]*"/g) ?? []).join(' ');
}

/** All tables of a language. */
async function tablesOf(language: Language): Promise<object> {
  return { ...(await loadWords(language)), viewer: await viewerWordsOf(language) };
}

const inEnglish = { ...english, viewer };
const others = languages.filter((language) => language !== 'en');

describe.each(others)('the table of %s', (language) => {
  it('has texts and functions where the English one has them', async () => {
    const kinds = (table: object): string[] =>
      entriesOf(table)
        .filter(([path]) => !path.startsWith('speech.'))
        .map(([path, value]) => `${path}: ${typeof value}`)
        .sort();
    expect(kinds(await tablesOf(language))).toEqual(kinds(inEnglish));
  });

  it('has no English left', async () => {
    const told = new Map(entriesOf(await tablesOf(language)));
    const left = entriesOf(inEnglish)
      .filter(([path]) => !path.startsWith('speech.'))
      .filter(([path, value]) => {
        const said = saidBy(value);
        return (
          /[A-Za-z]{3}/.test(said.replace(/\$\{[^}]*\}/g, '')) && said === saidBy(told.get(path))
        );
      })
      .map(([path]) => path);
    expect(left.sort()).toEqual([...(same[language] ?? [])].sort());
  });

  it.each(examples)('has words for %j', async ({ code, params }, original) => {
    const words = await loadWords(language);
    const phrase = phraseOf(words, { code, params: params as MessageParams });
    expect(phrase).not.toBe(words.unknown(code));
    expect(phrase).not.toMatch(/undefined|NaN|\[object/);
    // What the engine tells of an option in words of its own.
    if (!('detail' in params && params.detail === original)) expect(phrase).not.toBe(original);
    // Nothing is lost: a number or name of the one is in the other.
    for (const word of original.match(/'[^']*'|--\w+/g) ?? []) expect(phrase).toContain(word);
  });
});

describe('a language', () => {
  it('is found by its code with or without a region', () => {
    expect([languageOf('de'), languageOf('DE-at'), languageOf('tlh')]).toEqual(['de', 'de', null]);
    expect(spokenOf(['tlh', 'de-CH', 'en'])).toBe('de');
    expect(spokenOf([])).toBe('en');
  });

  it('has its own decimal signs, lists and plurals', () => {
    const { all, choose, figure, fixed, large } = speechOf('de');
    expect([figure(2.5), fixed(2, 1), large(69_451), large(1500)]).toEqual([
      '2,5',
      '2,0',
      '69.451',
      '1500',
    ]);
    expect(all(['A', 'B', 'C'])).toBe('A, B und C');
    expect([0, 1, 2].map((number) => choose(number, 'Teil', 'Teile'))).toEqual([
      'Teile',
      'Teil',
      'Teile',
    ]);
  });
});
