/** Where a text stops being JSON; browsers tell that in different words, or not at all. */

/** What may stand at a place: an `item` may also be the end of its list, a `field` that of its object. */
type Want = 'value' | 'item' | 'key' | 'field' | 'colon' | 'next' | 'end';

const string = String.raw`"(?:[^"\\\x00-\x1f]|\\(?:["\\/bfnrt]|u[\da-fA-F]{4}))*"`;
const number = String.raw`-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?`;
const value = `${string}|${number}|true|false|null|[{[]`;

const tokens: Readonly<Record<Want, RegExp>> = {
  value: new RegExp(value, 'y'),
  item: new RegExp(`${value}|]`, 'y'),
  key: new RegExp(string, 'y'),
  field: new RegExp(`${string}|}`, 'y'),
  colon: /:/y,
  next: /[,\]}]/y,
  end: /(?!)/y,
};

const space = /[ \t\n\r]*/y;

/** The length of what an expression finds at a place; -1 if it finds nothing. */
function lengthAt(expression: RegExp, text: string, at: number): number {
  expression.lastIndex = at;
  return expression.exec(text)?.[0].length ?? -1;
}

/** What may follow a token. @param open ends of the lists and objects that are open; changed by the token */
function wantAfter(token: string, want: Want, open: string[]): Want | null {
  if (token === '[' || token === '{') {
    open.push(token === '[' ? ']' : '}');
    return token === '[' ? 'item' : 'field';
  }
  if (token === ':') return 'value';
  if (token === ',') return open.at(-1) === '}' ? 'key' : 'value';
  if ((token === ']' || token === '}') && open.pop() !== token) return null;
  if (want === 'key' || (want === 'field' && token !== '}')) return 'colon';
  return open.length > 0 ? 'next' : 'end';
}

/** The place of the first character that cannot stand where it is; the length of the text if there is none. */
function faultAt(text: string): number {
  const open: string[] = [];
  let want: Want = 'value';
  for (let at = 0; ;) {
    at += lengthAt(space, text, at);
    const length = lengthAt(tokens[want], text, at);
    const next: Want | null =
      length < 0 ? null : wantAfter(text.slice(at, at + length), want, open);
    if (next === null) return at;
    at += length;
    want = next;
  }
}

/** Characters of a strange word that are told. */
const longest = 12;

export type JsonFault =
  | { what: 'cut-off' }
  /** Lines and characters in them count from 1. */
  | { what: 'word'; line: number; character: number; word: string };

/** Why a text is no JSON. @pre it is none */
export function jsonFault(text: string): JsonFault {
  const at = faultAt(text);
  const rest = text.slice(at);
  // A text, a number or a word that may have gone on.
  if (/^(?:"[^"]*|[\w.+-]*)$/.test(rest)) return { what: 'cut-off' };
  const before = text.slice(0, at).split('\n');
  const [word = ''] = /^(?:[\w.+-]+|.)/s.exec(rest) ?? [];
  return {
    what: 'word',
    line: before.length,
    character: before.at(-1)!.length + 1,
    word: word.slice(0, longest),
  };
}
