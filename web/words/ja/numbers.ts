/** Numbers and lists in Japanese sentences: nouns have no plural, and what is counted has its own counter. */
import { first, shown, speechOf } from '../speech.js';

export const speech = speechOf('ja');
export const { all, figure, fixed, large, rounded } = speech;

/** "7%", "1%未満" */
export function percentage(percent: number): string {
  return percent < 1 ? '1%未満' : `${figure(percent)}%`;
}

const more = (number: number): string => `ほか${figure(number)}個`;

/** The first of the names of files: "a.obj、b.obj、c.obj、ほか4個". */
export function some(names: readonly string[]): string {
  return all(first(names.map(shown), 3, more));
}

/** "ブロック3", "ブロック1、2、5" */
export function parts(numbers: readonly number[]): string {
  return `ブロック${all(numbers.map((part) => figure(part)))}`;
}

const mostPieces = 12;

/** "部品A", "部品A、B", "部品A、B、...、ほか7個" */
export function pieces(names: readonly string[]): string {
  return `部品${all(first(names, mostPieces, more))}`;
}
