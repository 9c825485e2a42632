/** Parsers for the values of options. A parser throws `BadValue` with what it would have taken. */
import {
  isRequested,
  isStep,
  isSwitch,
  requests,
  switchableSteps,
  type NeededStep,
  type RepairStep,
  type RequestedStep,
} from './repair-steps.js';
import { leastSide, mostSide, paperCalled, type PaperSize } from './paper.js';

export type Parser<Value> = (text: string) => Value;

/** What a value should have been, or else the word `or`; `part`: the piece of it that was to name a part. */
export type ValueFault = (
  | { expected: 'whole' | 'decimal' | 'dashes' | 'paper'; least: number; most: number }
  | { expected: 'words'; words: readonly string[] }
  | { expected: 'colour' | 'pair' }
  | { expected: 'switches'; steps: readonly RepairStep[] }
  | { expected: 'other-step'; step: NeededStep }
  | { expected: 'other-step'; step: RequestedStep; request: string }
) & { or?: string; part?: string };

/** A value that is not what it should be. */
export class BadValue extends Error {
  constructor(readonly fault: ValueFault) {
    super(fault.expected);
  }
}

/** A whole number in a range. */
export function whole(least: number, most: number): Parser<number> {
  return (text) => {
    const value = Number(text);
    if (/^\d+$/.test(text) && value >= least && value <= most) return value;
    throw new BadValue({ expected: 'whole', least, most });
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
      throw error instanceof BadValue ? new BadValue({ ...error.fault, or: word }) : error;
    }
  };
}

/** A decimal number in a range. */
export function decimal(least: number, most: number): Parser<number> {
  return (text) => {
    const value = Number(text);
    if (/^\d+(\.\d+)?$/.test(text) && value >= least && value <= most) return value;
    throw new BadValue({ expected: 'decimal', least, most });
  };
}

/** One of some words. */
export function choice<const Word extends string>(words: readonly Word[]): Parser<Word> {
  return (text) => {
    const word = words.find((candidate) => candidate === text);
    if (word !== undefined) return word;
    throw new BadValue({ expected: 'words', words });
  };
}

/** Six hexadecimal digits after '#'; comes back in lower case. */
export function colour(text: string): string {
  if (/^#[\da-f]{6}$/i.test(text)) return text.toLowerCase();
  throw new BadValue({ expected: 'colour' });
}

/** Two values with a comma between them. */
export function pair<Value>(parse: Parser<Value>): Parser<[Value, Value]> {
  return (text) => {
    const [first, second, ...more] = text.split(',');
    if (second !== undefined && more.length === 0) return [parse(first!), parse(second)];
    throw new BadValue({ expected: 'pair' });
  };
}

// Shorter than a dot of ink, and longer than any fold of a model that fits on paper.
const dashLengths = { least: 0.05, most: 50 } as const;
const dashLength = decimal(dashLengths.least, dashLengths.most);

/** Lengths of dashes and gaps in turn, with commas between them; none for 'solid'. */
export function dashes(text: string): number[] {
  if (text === 'solid') return [];
  const lengths = text.split(',');
  if (lengths.length % 2 === 0) return lengths.map(dashLength);
  throw new BadValue({ expected: 'dashes', ...dashLengths });
}

/** Splits 'weld=off'. @throws BadValue for what is no switch of a step */
function stepSwitch(text: string): { step: RepairStep; isOff: boolean } {
  const [name = '', value = '', ...more] = text.split('=');
  if ((value !== 'on' && value !== 'off') || more.length > 0 || !isStep(name)) {
    throw new BadValue({ expected: 'switches', steps: switchableSteps });
  }
  if (isSwitch(name)) return { step: name, isOff: value === 'off' };
  if (isRequested(name)) {
    throw new BadValue({ expected: 'other-step', step: name, request: requests[name] });
  }
  throw new BadValue({ expected: 'other-step', step: name });
}

/** The steps that a list such as 'weld=off,cracks=off' switches off, in their own order; none for 'on'. */
export function repairsOff(text: string): RepairStep[] {
  const off = new Set<RepairStep>();
  for (const word of text.split(',')) {
    if (word === 'on') {
      off.clear();
      continue;
    }
    const { step, isOff } = stepSwitch(word);
    if (isOff) off.add(step);
    else off.delete(step);
  }
  return switchableSteps.filter((step) => off.has(step));
}

/** A named paper, or width x height in mm; comes back portrait. */
export function paper(text: string): PaperSize {
  const found = paperCalled(text);
  if (found) return found;
  throw new BadValue({ expected: 'paper', least: leastSide, most: mostSide });
}
