/** Numbers and lists in English sentences. */
import { first, shown, speechOf } from '../speech.js';

// Of Britain, whose lists have no comma before "and".
export const speech = speechOf('en-GB');
export const { all, choose, figure, fixed, large, rounded } = speech;

/** "1 edge", "2 edges" */
export function count(number: number, one: string, many = `${one}s`): string {
  return speech.count(number, one, many);
}

/** "7 %", "less than 1 %" */
export function percentage(percent: number): string {
  return percent < 1 ? 'less than 1 %' : `${figure(percent)} %`;
}

const more = (number: number): string => `${figure(number)} more`;

/** The first of the names of files: "a.obj, b.obj, c.obj and 4 more". */
export function some(names: readonly string[]): string {
  return all(first(names.map(shown), 3, more));
}

/** "part 3", "parts 1 and 2", "parts 1, 2 and 5" */
export function parts(numbers: readonly number[]): string {
  return `${choose(numbers.length, 'part', 'parts')} ${all(numbers.map((part) => figure(part)))}`;
}

const mostPieces = 12;

/** "piece A", "pieces A, B", "pieces A, B, ... and 7 more" */
export function pieces(names: readonly string[]): string {
  const list = names.length > mostPieces ? all(first(names, mostPieces, more)) : names.join(', ');
  return `${choose(names.length, 'piece', 'pieces')} ${list}`;
}
