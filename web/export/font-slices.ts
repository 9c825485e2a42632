/** Which file of the fonts that come along has a letter. The files are small: only few are loaded. */
import japanese from '@fontsource/biz-udpgothic/unicode.json';
import western from '@fontsource/noto-sans/unicode.json';

/** A file with a share of a font's letters. */
export interface FontSlice {
  /** Without a folder. */
  file: string;
  has: (letter: number) => boolean;
}

type Ranges = readonly [from: number, to: number][];

/** Reads 'U+41-5a,U+e4'. */
function parseRanges(text: string): Ranges {
  return text.split(',').map((range) => {
    const [from, to] = range.slice(2).split('-');
    return [Number.parseInt(from!, 16), Number.parseInt(to ?? from!, 16)];
  });
}

function slicesOf(font: string, table: Record<string, string>, skip: string[]): FontSlice[] {
  return Object.entries(table)
    .filter(([name]) => !skip.includes(name))
    .map(([name, text]) => {
      const ranges = parseRanges(text);
      return {
        file: `${font}-${name.replace(/[[\]]/g, '')}-400-normal.woff`,
        has: (letter) => ranges.some(([from, to]) => letter >= from && letter <= to),
      };
    });
}

/** In the order in which they are asked; Latin letters first. */
export const fontSlices: readonly FontSlice[] = [
  // Its letters change their shapes with their neighbours, which takes more than a list of glyphs.
  ...slicesOf('noto-sans', western, ['devanagari']).reverse(),
  ...slicesOf('biz-udpgothic', japanese, ['latin', 'latin-ext', 'cyrillic', 'greek-ext']),
];
