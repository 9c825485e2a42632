/** What stands in Spanish on the sheets that are cut, and beside lines in files. */
import type { Words } from '../words.js';
import { figure } from './numbers.js';

export const sheets: Words['sheets'] = {
  note: (sheet, of) => `hoja ${figure(sheet)} de ${figure(of)} · imprimir al 100 %`,
  corrected: (across, up) => `corregido para ${figure(across)} × ${figure(up)} mm`,
  outside: ['este lado', 'va por fuera'],
  back: (sheet, of) =>
    `reverso de la hoja ${figure(sheet)} de ${figure(of)} · este lado va por dentro: pliegues vistos desde aquí`,
  backHow: 'imprimir a doble cara, volteando por el borde largo · a contraluz las cruces coinciden',
  legend: {
    cut: 'línea de corte',
    mountain: 'pliegue en montaña',
    valley: 'pliegue en valle',
    ticks: 'plegar de marca a marca',
    flap: 'pestaña para pegar',
    number: '12: se une al otro 12',
    underlined: 'número con raya: la raya va abajo',
    pair: 'C3 en la pieza A: se une a A3 en la pieza C',
    tape: 'dos rayas sobre una arista: cinta adhesiva',
    strip: 'tira A-C:3: detrás de la arista C3 de A',
    angle: '34°: ángulo del pliegue',
  },
};
