/** What the studio says in Spanish of the work that a browser keeps. */
import type { Words } from '../words.js';
import { figure } from './numbers.js';

const quoted = (name: string): string => `«${name}»`;

const relative = new Intl.RelativeTimeFormat('es', { numeric: 'auto' });

export const keeping: Words['keeping'] = {
  goOn: (name, isPending) =>
    isPending ? `Desplegar ${quoted(name)} otra vez` : `Seguir con ${quoted(name)}`,
  ago: (number, unit) => relative.format(-number, unit),
  justNow: 'hace un momento',
  showAll: (number) => `Ver todos (${figure(number)})`,
  rename: 'Renombrar',
  copy: 'Copiar',
  remove: 'Borrar',
  about: (word, name) => `${word} ${quoted(name)}`,
  newName: (name) => `Nombre nuevo de ${quoted(name)}`,
  kept: 'Se guarda en este navegador. Para tenerlo también en otro sitio, descarga el proyecto.',
  none: 'Este navegador no guarda nada de esta página. Descarga el proyecto antes de irte.',
  scarce:
    'Queda poco espacio en este dispositivo. Borra trabajos antiguos o descarga el proyecto antes de irte.',
  unfinished: 'sin terminar',
  deleted: (name) => `${quoted(name)} se ha borrado.`,
  copyOf: (name) => `Copia de ${name}`,
  full: [
    'Tus últimos cambios no se han guardado',
    'No queda espacio en este dispositivo. Borra trabajos antiguos en la página de inicio o descarga el proyecto, para que no se pierda nada.',
  ],
  lost: [
    'Tu trabajo no se ha guardado',
    'Este navegador no guarda nada de esta página. Descarga el proyecto antes de irte, para que no se pierda nada.',
  ],
  copied: (name) => [
    'Este trabajo también se cambió en otra página',
    `Se guardan los dos: lo que ves aquí sigue como ${quoted(name)}.`,
  ],
  deletedElsewhere: (name) => [
    `${quoted(name)} se borró en otra página`,
    'Lo que ves aquí ya no se guarda. Consérvalo para que no se pierda nada.',
  ],
  keepIt: 'Conservarlo',
  gone: (name) => `${quoted(name)} ya no está.`,
};
