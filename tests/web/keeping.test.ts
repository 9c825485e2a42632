import { describe, expect, it } from 'vitest';
import { nextName } from '../../web/app/keeper.js';
import { titleOf } from '../../web/model/model-files.js';
import { methodFields } from '../../web/app/paper-fields.js';
import { changedSettings, defaultSettings } from '../../web/api/written-options.js';
import { agoWords } from '../../web/words/ago.js';
import { english } from '../../web/words/en/index.js';

describe('kept work', () => {
  it('is named by its model, and copies by a number', () => {
    expect(titleOf('models/my ring.v2.obj')).toBe('my ring.v2');
    expect(titleOf('.obj')).toBe('.obj');
    expect(nextName('ring')).toBe('ring (2)');
    expect(nextName('ring (2)')).toBe('ring (3)');
    expect(nextName('ring (old)')).toBe('ring (old) (2)');
  });

  it('says how long ago it was', () => {
    const ago = (seconds: number): string => agoWords(english, 0, seconds * 1000);
    expect([ago(-5), ago(0), ago(59)]).toEqual(['just now', 'just now', 'just now']);
    expect([ago(60), ago(7300), ago(86_400)]).toEqual(['1 minute ago', '2 hours ago', 'yesterday']);
    expect([ago(15 * 86_400), ago(800 * 86_400)]).toEqual(['2 weeks ago', '2 years ago']);
    expect(english.keeping.goOn('ring', false)).toBe('Go on with “ring”');
    expect(english.keeping.goOn('ring', true)).toBe('Unfold “ring” again');
  });

  it('fills in the fields of its method', () => {
    const settings = changedSettings(defaultSettings(), { seed: 7, folding: 'off', up: 'z' });
    const fields = Object.fromEntries(methodFields(settings));
    expect(fields).toMatchObject({ parts: '', seed: '7', 'folding-mode': 'off', up: 'z' });
  });
});
