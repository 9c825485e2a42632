/** Reads MTL files, in which OBJ files have their materials. */
import type { Wrap } from '../model/looks.js';
import { ofShown, type Colour } from './colours.js';

export interface MtlPicture {
  /** As the file has it: with blanks, backslashes or a drive of another computer. */
  path: string;
  wrap: Wrap;
  /** To the right and up. */
  scale: readonly [number, number];
  offset: readonly [number, number];
}

export interface MtlMaterial {
  name: string;
  /** Null where nothing is said of it. */
  colour: Colour | null;
  picture: MtlPicture | null;
}

/** Bytes: some ten thousand materials. What is larger is no MTL file. */
const mostBytes = 16 * 2 ** 20;

/** Letters. What is longer is no line of an MTL file. */
const longestLine = 4096;

/** Numbers that follow an option of a picture, at most. */
const numbersOf: Readonly<Record<string, number>> = { '-mm': 2, '-o': 3, '-s': 3, '-t': 3 };

/** Options that one word follows. */
const withWord = /^-(?:blendu|blendv|boost|bm|cc|clamp|imfchan|texres|type)$/;

const isNumber = (word: string): boolean => Number.isFinite(Number(word));

/** How many of the words after an option belong to it. */
function lengthOf(option: string, words: readonly string[]): number {
  if (withWord.test(option)) return 1;
  const others = words.slice(0, numbersOf[option]).findIndex((word) => !isNumber(word));
  return others === -1 ? (numbersOf[option] ?? 0) : others;
}

/** The first two numbers after an option; those that are left out change nothing. */
function pair(words: readonly string[] | undefined, usual: number): [number, number] {
  const [first = usual, second = usual] = (words ?? []).map(Number);
  return [first, second];
}

/** A picture with its options: "-s 2 2 1 -clamp on wood grain.png". */
function pictureOf(rest: string): MtlPicture | null {
  const words = [...rest.matchAll(/\S+/g)];
  const options = new Map<string, string[]>();
  let next = 0;
  for (let option = words[0]?.[0]; option !== undefined; option = words[next]?.[0]) {
    if (!withWord.test(option) && !(option in numbersOf)) break;
    // The last word is the picture's, whatever it looks like.
    const following = words.slice(next + 1, -1).map(([word]) => word);
    const length = Math.min(following.length, lengthOf(option, following));
    options.set(option, following.slice(0, length));
    next += 1 + length;
  }
  const begin = words[next]?.index;
  if (begin === undefined) return null;
  return {
    path: rest.slice(begin).replace(/^"(.*)"$/, '$1'),
    wrap: options.get('-clamp')?.[0] === 'on' ? 'clamp' : 'repeat',
    scale: pair(options.get('-s'), 1),
    offset: pair(options.get('-o'), 0),
  };
}

/** Null for one in another notation than red, green and blue. */
function colourOf(rest: string): Colour | null {
  const [red, green, blue] = rest.split(/\s+/).map(Number);
  if (red === undefined || !Number.isFinite(red)) return null;
  return ofShown([red, green ?? red, blue ?? red]);
}

/** First word and all behind it, of each line that has both. */
function* statements(bytes: Uint8Array): Generator<[string, string]> {
  // Names must come out as the engine has them: bytes that are no UTF-8 are marked alike.
  const text = new TextDecoder().decode(bytes).replace(/\\\r?\n/g, ' ');
  for (const line of text.split(/[\r\n]+/)) {
    const [keyword = ''] = /^\S+/.exec(line.trim()) ?? [];
    const rest = line.trim().slice(keyword.length).trim();
    if (rest !== '' && line.length <= longestLine) yield [keyword.toLowerCase(), rest];
  }
}

/** All materials of a file in its order; none for a file that is no MTL file. */
export function readMtl(bytes: Uint8Array): MtlMaterial[] {
  const materials: MtlMaterial[] = [];
  if (bytes.length > mostBytes) return materials;
  for (const [keyword, rest] of statements(bytes)) {
    if (keyword === 'newmtl') materials.push({ name: rest, colour: null, picture: null });
    const last = materials.at(-1);
    if (last && keyword === 'kd') last.colour ??= colourOf(rest);
    if (last && keyword === 'map_kd') last.picture ??= pictureOf(rest);
  }
  return materials;
}
