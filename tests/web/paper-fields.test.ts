import { describe, expect, it } from 'vitest';
import { changedSettings, defaultSettings } from '../../web/api/written-options.js';
import { paperFields } from '../../web/app/paper-fields.js';

const fieldsOf = (options: Record<string, unknown>) =>
  Object.fromEntries(paperFields(changedSettings(defaultSettings(), options)));

describe('the fields of sheets, size, flaps and numbers', () => {
  it('say what settings ask for', () => {
    expect(fieldsOf({})).toEqual({
      paper: 'A4',
      orientation: 'auto',
      margin: '10',
      sizing: 'fit',
      size: '',
      'flap-side': 'one',
      'flap-style': 'run',
      'flap-height': '5',
      strips: 'false',
      ids: 'flap',
    });
    expect(fieldsOf({ height: 149, glueStrips: 'all', paper: 'Letter' })).toMatchObject({
      paper: 'Letter',
      sizing: 'height',
      size: '149',
      strips: 'true',
    });
  });

  it('have no height of flaps where there are none', () => {
    const fields = fieldsOf({ flaps: 'none' });
    expect(fields['flap-side']).toBe('none');
    expect(fields).not.toHaveProperty('flap-height');
  });
});
