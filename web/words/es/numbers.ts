/** Numbers, lists and counted nouns in Spanish sentences. */
import { first, shown, speechOf } from '../speech.js';

export const speech = speechOf('es');
export const { all, choose, count, figure, fixed, large, rounded } = speech;

/** `counted.faces(2)`: "2 caras" */
export const counted = {
  bodies: (number: number): string => count(number, 'cuerpo', 'cuerpos'),
  edges: (number: number): string => count(number, 'arista', 'aristas'),
  faces: (number: number): string => count(number, 'cara', 'caras'),
  flaps: (number: number): string => count(number, 'pestaña', 'pestañas'),
  folds: (number: number): string => count(number, 'pliegue', 'pliegues'),
  overlaps: (number: number): string => count(number, 'solape', 'solapes'),
  parts: (number: number): string => count(number, 'parte', 'partes'),
  pieces: (number: number): string => count(number, 'pieza', 'piezas'),
  seams: (number: number): string => count(number, 'unión', 'uniones'),
  sheets: (number: number): string => count(number, 'hoja', 'hojas'),
  templates: (number: number): string => count(number, 'plantilla', 'plantillas'),
  triangles: (number: number): string => count(number, 'triángulo', 'triángulos'),
} as const;

/** "el 7 %", "menos del 1 %" */
export function percentage(percent: number): string {
  return percent < 1 ? 'menos del 1 %' : `el ${figure(percent)} %`;
}

const more = (number: number): string => `${figure(number)} más`;

/** The first of the names of files: "a.obj, b.obj, c.obj y 4 más". */
export function some(names: readonly string[]): string {
  return all(first(names.map(shown), 3, more));
}

/** "la parte 3", "las partes 1 y 2" */
export function parts(numbers: readonly number[]): string {
  return `${choose(numbers.length, 'la parte', 'las partes')} ${all(numbers.map((part) => figure(part)))}`;
}

const mostPieces = 12;

/** "la pieza A", "las piezas A, B", "las piezas A, B, ... y 7 más" */
export function pieces(names: readonly string[]): string {
  const list = names.length > mostPieces ? all(first(names, mostPieces, more)) : names.join(', ');
  return `${choose(names.length, 'la pieza', 'las piezas')} ${list}`;
}
