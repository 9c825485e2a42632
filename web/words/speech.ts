/** Numbers, plurals and lists as a language has them. */

/** What `Intl` knows of a language, for the sentences in it. */
export interface Speech {
  /** A number as it is, without marks between thousands; rounded to so many digits after the point. */
  figure: (value: number, mostDigits?: number) => string;
  /** The same with all of those digits: "2.0". */
  fixed: (value: number | undefined, digits: number) => string;
  /** With so many digits that count: "0.0023". */
  rounded: (value: number, digits?: number) => string;
  /** 1500, but 69,451 with marks: to be grasped and not to be typed. */
  large: (value: number) => string;
  /** The form of a word that goes with a number. */
  choose: (number: number, one: string, many: string) => string;
  /** "1 edge", "2 edges" */
  count: (number: number, one: string, many: string) => string;
  /** "A, B and C" */
  all: (names: readonly string[]) => string;
}

const smallest = 10_000;

/** @param language its code (BCP 47) */
export function speechOf(language: string): Speech {
  const plurals = new Intl.PluralRules(language);
  const list = new Intl.ListFormat(language, { type: 'conjunction' });
  const number = (value: number, options: Intl.NumberFormatOptions): string =>
    new Intl.NumberFormat(language, { useGrouping: false, ...options }).format(value);
  const figure: Speech['figure'] = (value, mostDigits = 20) =>
    number(value, { maximumFractionDigits: mostDigits });
  const choose: Speech['choose'] = (amount, one, many) =>
    plurals.select(amount) === 'one' ? one : many;
  return {
    figure,
    fixed: (value, digits) => {
      // Of a message that lacks it.
      if (value === undefined) throw new TypeError('no number');
      return number(value, { minimumFractionDigits: digits, maximumFractionDigits: digits });
    },
    rounded: (value, digits = 2) => number(value, { maximumSignificantDigits: digits }),
    large: (value) => number(value, { useGrouping: value >= smallest }),
    choose,
    count: (amount, one, many) => `${figure(amount)} ${choose(amount, one, many)}`,
    all: (names) => list.format(names),
  };
}

/** Longer names are cut in their middle. */
const longestName = 60;

/** A file's name, which may hold anything: without control characters, and not too long for a line. */
export function shown(name: string): string {
  const line = name.replace(/\p{C}/gu, '\u{FFFD}');
  if (line.length <= longestName) return line;
  return `${line.slice(0, longestName / 2)}…${line.slice(1 - longestName / 2)}`;
}

/** The first names, and in `more` words how many others there are: a longer list is not read. */
export function first(
  names: readonly string[],
  most: number,
  more: (number: number) => string,
): string[] {
  const others = names.length - most;
  return others > 0 ? [...names.slice(0, most), more(others)] : [...names];
}
