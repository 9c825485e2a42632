/** Numbers, lists and quotation marks in French sentences, with the no-break spaces that belong to them. */
import { first, shown, speechOf } from '../speech.js';

export const speech = speechOf('fr');
export const { all, choose, count, figure, fixed, large, rounded } = speech;

/** "7 %", "moins de 1 %" */
export function percentage(percent: number): string {
  return percent < 1 ? 'moins de 1\u202f%' : `${figure(percent)}\u202f%`;
}

/** "« Lapin »" */
export function quoted(text: string): string {
  return `«\u202f${text}\u202f»`;
}

const more = (number: number): string => count(number, 'autre', 'autres');

/** The first of the names of files: "a.obj, b.obj, c.obj et 4 autres". */
export function some(names: readonly string[]): string {
  return all(first(names.map(shown), 3, more));
}

const numbers = (parts: readonly number[]): string => all(parts.map((part) => figure(part)));

/** "la partie 3", "les parties 1 et 2" */
export function parts(list: readonly number[]): string {
  return `${choose(list.length, 'la partie', 'les parties')} ${numbers(list)}`;
}

/** "de la partie 3", "des parties 1 et 2" */
export function ofParts(list: readonly number[]): string {
  return `${choose(list.length, 'de la partie', 'des parties')} ${numbers(list)}`;
}

const mostPieces = 12;

function letters(names: readonly string[]): string {
  return names.length > mostPieces ? all(first(names, mostPieces, more)) : names.join(', ');
}

/** "la pièce A", "les pièces A, B", "les pièces A, B, ... et 7 autres" */
export function pieces(names: readonly string[]): string {
  return `${choose(names.length, 'la pièce', 'les pièces')} ${letters(names)}`;
}

/** "de la pièce A", "des pièces A, B" */
export function ofPieces(names: readonly string[]): string {
  return `${choose(names.length, 'de la pièce', 'des pièces')} ${letters(names)}`;
}
