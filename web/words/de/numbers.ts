/** Numbers and lists in German sentences. */
import { first, shown, speechOf } from '../speech.js';

export const speech = speechOf('de');
export const { all, choose, count, figure, fixed, large, rounded } = speech;

/** "7 %", "weniger als 1 %" */
export function percentage(percent: number): string {
  return percent < 1 ? 'weniger als 1 %' : `${figure(percent)} %`;
}

const more = (number: number): string => `${figure(number)} weitere`;

/** The first of the names of files: "a.obj, b.obj, c.obj und 4 weitere". */
export function some(names: readonly string[]): string {
  return all(first(names.map(shown), 3, more));
}

/** "Abschnitt 3", "Abschnitte 1 und 2" */
export function parts(numbers: readonly number[]): string {
  return `${choose(numbers.length, 'Abschnitt', 'Abschnitte')} ${all(numbers.map((part) => figure(part)))}`;
}

const mostPieces = 12;

/** "Teil A", "Teile A, B", "Teile A, B, ... und 7 weitere"; in the dative "Teilen A, B". */
export function pieces(names: readonly string[], many = 'Teile'): string {
  const list = names.length > mostPieces ? all(first(names, mostPieces, more)) : names.join(', ');
  return `${choose(names.length, 'Teil', many)} ${list}`;
}
