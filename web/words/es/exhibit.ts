/** What is said in Spanish of a file that is shown with the nets that it brings along. */
import type { Words } from '../words.js';
import { all, choose, figure } from './numbers.js';

export const exhibit: Words['exhibit'] = {
  lead: (pieces) =>
    `Esto es solo para mirar: el modelo y ${choose(pieces, 'su plantilla', `sus ${figure(pieces)} plantillas`)} se ven como están en el archivo, ` +
    'y aquí no se pueden cambiar ni imprimir. Si lo despliegas de nuevo, el modelo recibe plantillas y hojas nuevas.',
  nets: (name, pieces) =>
    `Plantillas de ${name} como en el archivo: ${figure(pieces)} ${choose(pieces, 'pieza', 'piezas')}`,
  piece: (name) => `Pieza ${name}`,
  chosen: (names) =>
    `${choose(names.length, 'Resalta la pieza', 'Resaltan las piezas')} ${all(names)}.`,
};
