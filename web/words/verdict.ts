/** What a verdict says to whoever wants to build a model, and what its buttons do; `en/verdict.ts` says it in English. */
import type { Remedy } from '../model/remedies.js';
import type { Conclusion, Finding, FindingCode, FindingParams, Level } from '../model/verdict.js';

/** A row of a verdict: what is found, and what it means or what to do about it; the second may be empty. */
export interface FindingWords {
  title: string;
  hint: string;
}

type Bad<Code extends FindingCode> = (
  found: FindingParams[Code] & { count: number; isRed: boolean },
) => FindingWords;

/** The words of a language. */
export interface VerdictWords {
  /** Of each kind of finding, what is said where all is well, and else. */
  findings: {
    readonly [Code in FindingCode]: {
      good: (params: FindingParams[Code]) => string;
      bad: Bad<Code>;
    };
  };
  /** Before the words of a row, for those who do not see its sign: `good` with a colon. */
  levels: Readonly<Record<Level, string>>;
  /** The verdict in one line; `rows`: how many findings there are to look at. */
  headline: (conclusion: Conclusion, rows: number) => string;
  /** How many rows there are at which all is well. */
  good: (number: number) => string;
  /** What a button does that mends something. */
  remedy: (remedy: Remedy) => string;
}

/** A row in words. */
export function findingWords(
  { findings }: VerdictWords,
  { code, level, count: number, params }: Finding,
): FindingWords {
  const { good, bad } = findings[code] as VerdictWords['findings']['unfinished'];
  if (level === 'green' && number === 0) return { title: good(params), hint: '' };
  if (level === 'green' && code === 'long-building') return { title: good(params), hint: '' };
  return bad({ ...params, count: number, isRed: level === 'red' });
}
