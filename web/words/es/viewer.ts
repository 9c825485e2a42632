/** What `<foldwright-viewer>` says in Spanish. */
import type { ViewerWords } from '../en/viewer.js';
import { count, figure } from './numbers.js';

export const viewer: ViewerWords = {
  unfold: 'Desplegar',
  show: 'Mostrar el modelo',
  cancel: 'Cancelar',
  play: 'Reproducir',
  pause: 'Pausar',
  slider: 'Cuánto está plegado',
  percent: ({ share }) => `${figure(Math.floor(100 * share))} %`,
  flat: 'plano',
  folded: 'plegado',
  foldedBy: ({ time }) => `plegado al ${figure(Math.floor(100 * time))} %`,
  downloads: 'Descargar',
  model: ({ name, pieces }) =>
    `${name} como modelo de papel de ${count(pieces, 'pieza', 'piezas')}. Las flechas del teclado lo giran`,
  nets: ({ name, pieces }) =>
    `Plantillas de ${name}: ${count(pieces, 'pieza', 'piezas')} para recortar`,
  sheet: ({ sheet, sheets }) => `Hoja ${figure(sheet)} de ${figure(sheets)}`,
  noPicture: 'Este navegador no puede dibujar el modelo en 3D.',
  faults: {
    'no-model': 'Todavía no hay ningún modelo que desplegar.',
    'not-loaded': 'El modelo no se puede cargar.',
    'not-fold':
      'Este archivo FOLD no contiene un modelo con sus plantillas como las escribe Foldwright.',
    'not-unfolded': 'El modelo todavía no se ha desplegado.',
    'not-written':
      'Esto no se puede hacer a partir de un archivo FOLD: despliega el modelo para ello.',
    removed: 'El visor ya no está en la página.',
  },
};
