import { describe, expect, it } from 'vitest';
import type { MessageParams } from '../../web/model/message.js';
import { english } from '../../web/words/en/index.js';
import type { OwnMessages } from '../../web/words/messages.js';
import { englishPhrase, repairPhrase } from '../../web/words/phrase.js';
import { examples } from './message-examples.js';

/** Codes of what TypeScript finds itself; the type makes the list complete. */
const own = Object.keys({
  'engine-died': 0,
  'edit-place-gone': 0,
  overtaken: 0,
  'no-piece': 0,
  'not-pinned': 0,
  'not-together': 0,
  'no-legend': 0,
  'beyond-page': 0,
  'missing-glyphs': 0,
  'fonts-not-loaded': 0,
  'no-looks': 0,
  'pictures-unreadable': 0,
  'pictures-not-loaded': 0,
  'marks-not-free': 0,
  'cricut-area': 0,
  'missing-names': 0,
  'missing-flaps': 0,
  'missing-numbers': 0,
  'overlapping-pieces': 0,
  'short-seams': 0,
  'empty-sheet': 0,
  'tiny-pieces': 0,
  'equal-pieces': 0,
  'bad-project': 0,
  'project-damaged': 0,
  'project-options-lost': 0,
  'project-redrawn': 0,
  'run-stopped': 0,
  'bad-3mf': 0,
  'bad-archive': 0,
  'bad-fold': 0,
  'bad-gltf': 0,
  'missing-files': 0,
  'no-model-in-archive': 0,
  'reader-not-loaded': 0,
  'uniter-not-loaded': 0,
  'too-many-triangles': 0,
  'damaged-looks': 0,
  'large-pictures': 0,
  'lost-looks': 0,
  'missing-looks': 0,
  'picture-guessed': 0,
  'simplified-looks': 0,
  'unknown-materials': 0,
  'unread-libraries': 0,
  'unread-pictures': 0,
  'archive-choice': 0,
  'not-for-printing': 0,
  'posed-skins': 0,
  'unknown-extensions': 0,
  'bad-pdo': 0,
  'broken-faces': 0,
  'damaged-extras': 0,
  'file-nets-kept': 0,
  'parts-unused': 0,
  'file-nets-lost': 0,
  'file-nets-unused': 0,
  'fold-nets-unused': 0,
  'pdo-unused': 0,
  'unused-content': 0,
} satisfies Record<keyof OwnMessages, 0>);

async function engineCodes(): Promise<string[]> {
  const { default: start } = await import('../../web/core/generated/foldwright.mjs');
  return (await start()).messageCodes();
}

describe('the table of messages', () => {
  it('has a sentence for every code that there is, and none for others', async () => {
    const codes = [...(await engineCodes()), ...own];
    expect(Object.keys(english.messages).sort()).toEqual(codes.sort());
  });

  it.each(examples.map(([message, words]) => [words, message] as const))(
    'says “%s”',
    (words, message) => {
      expect(englishPhrase({ code: message.code, params: message.params as MessageParams })).toBe(
        words,
      );
    },
  );

  it('counts repairs', () => {
    const repair = { code: 'halved-edges', count: 2, params: {} };
    expect(repairPhrase(english, repair)).toMatch(/^2 edges were halved/);
  });

  it('names the code of a message that it does not know', () => {
    expect(englishPhrase({ code: 'no-such-code', params: {} })).toBe("message 'no-such-code'");
    expect(englishPhrase({ code: 'toString', params: {} })).toBe("message 'toString'");
    expect(englishPhrase({ code: 'beyond-page', params: {} })).toBe("message 'beyond-page'");
  });
});
