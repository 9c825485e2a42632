import { describe, expect, it } from 'vitest';
import { askedFields } from '../../web/app/asked-options.js';
import { requestedAttributes } from '../../web/app/page-request.js';

const requested = (search: string) => Object.fromEntries(requestedAttributes(search));

describe('the address of the page', () => {
  it('asks for a model with options', () => {
    expect(requested('?model=a%20b/whale.obj&parts=6&paper=A3&height=150&flaps=none')).toEqual({
      src: 'a b/whale.obj',
      parts: '6',
      paper: 'A3',
      options: 'height=150&flaps=none',
    });
  });

  it('may have names that other sites have added', () => {
    expect(requested('?utm_source=mail&model=')).toEqual({});
  });
});

describe('options of an address', () => {
  const asked = (text: string) => Object.fromEntries(askedFields(text));

  it('fill in the fields that they change, and no others', () => {
    expect(asked('')).toEqual({});
    expect(asked('height=150&flaps=6&ids=flap')).toEqual({
      sizing: 'height',
      size: '150',
      'flap-height': '6',
    });
    expect(asked('flaps=none&up=z')).toEqual({ 'flap-side': 'none', up: 'z' });
  });

  it.each([
    ['heigth=150', "there is no option 'heigth'"],
    ['height=tall', "option 'height': 'tall'"],
    ['height=100&width=50', 'the size is given by'],
    ['duplex=on', "option 'duplex' cannot be changed here"],
  ])('are refused in %s', (text, words) => {
    expect(() => askedFields(text)).toThrow(words);
  });
});
