import { describe, expect, it } from 'vitest';
import { paperCalled } from '../../web/model/paper.js';

describe('paperCalled', () => {
  it('knows papers by their names, in upper or lower case', () => {
    expect(paperCalled('letter')).toEqual({ name: 'Letter', width: 215.9, height: 279.4 });
    expect(paperCalled('12X12IN')?.width).toBe(304.8);
  });

  it('takes two lengths in mm and turns the sheet upright', () => {
    expect(paperCalled('300x200.5')).toEqual({ name: '300x200.5', width: 200.5, height: 300 });
  });

  it('refuses what is no paper, and what no machine takes', () => {
    const none = ['', 'A9', '300', '300x', 'x200', '-300x200', '19x200', '300x5001', '1e3x200'];
    expect(none.filter((text) => paperCalled(text) !== null)).toEqual([]);
  });
});
