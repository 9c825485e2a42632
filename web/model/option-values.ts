/** Parsers for the values of options. A parser throws `BadValue` with what it would have taken. */
import { leastSide, mostSide, paperCalled, paperSizes, type PaperSize } from './paper.js';

export type Parser<Value> = (text: string) => Value;

/** Says what is wrong, to be read after the value itself: "is not ...". */
export class BadValue extends Error {}

/** A whole number in a range. */
export function whole(least: number, most: number): Parser<number> {
  return (text) => {
    const value = Number(text);
    if (/^\d+$/.test(text) && value >= least && value <= most) return value;
    throw new BadValue(`is not a whole number from ${least} to ${most}`);
  };
}

/** A word, or what another parser takes. */
export function wordOr<const Word extends string, Value>(
  word: Word,
  parse: Parser<Value>,
): Parser<Word | Value> {
  return (text) => {
    if (text === word) return word;
    try {
      return parse(text);
    } catch (error) {
      throw error instanceof BadValue ? new BadValue(`${error.message}, nor ${word}`) : error;
    }
  };
}

/** A decimal number in a range. */
export function decimal(least: number, most: number): Parser<number> {
  return (text) => {
    const value = Number(text);
    if (/^\d+(\.\d+)?$/.test(text) && value >= least && value <= most) return value;
    throw new BadValue(`is not a number from ${least} to ${most}`);
  };
}

/** One of some words. */
export function choice<const Word extends string>(words: Word[]): Parser<Word> {
  return (text) => {
    const word = words.find((candidate) => candidate === text);
    if (word !== undefined) return word;
    throw new BadValue(`is not ${words.join(' or ')}`);
  };
}

/** Six hexadecimal digits after '#'; comes back in lower case. */
export function colour(text: string): string {
  if (/^#[\da-f]{6}$/i.test(text)) return text.toLowerCase();
  throw new BadValue('is not #RRGGBB');
}

/** Two values with a comma between them. */
export function pair<Value>(parse: Parser<Value>): Parser<[Value, Value]> {
  return (text) => {
    const [first, second, ...more] = text.split(',');
    if (second !== undefined && more.length === 0) return [parse(first!), parse(second)];
    throw new BadValue('is not two values with a comma between them');
  };
}

// Shorter than a dot of ink, and longer than any fold of a model that fits on paper.
const dashLength = decimal(0.05, 50);

/** Lengths of dashes and gaps in turn, with commas between them; none for 'solid'. */
export function dashes(text: string): number[] {
  if (text === 'solid') return [];
  const lengths = text.split(',');
  if (lengths.length % 2 === 0) return lengths.map(dashLength);
  throw new BadValue('is neither solid nor lengths of dashes and gaps in turn, from 0.05 to 50');
}

/** A named paper, or width x height in mm; comes back portrait. */
export function paper(text: string): PaperSize {
  const found = paperCalled(text);
  if (found) return found;
  const names = paperSizes.map(({ name }) => name).join(', ');
  throw new BadValue(`is neither ${names} nor WxH with ${leastSide} to ${mostSide} mm each`);
}
