/** What a verdict says in Spanish. */
import type { Remedy } from '../../model/remedies.js';
import type { Conclusion, FindingParams } from '../../model/verdict.js';
import type { FindingWords, VerdictWords } from '../verdict.js';
import { building } from './building.js';
import { all, choose, count, counted, figure, percentage, pieces } from './numbers.js';

/** A length in mm that is not told more exactly than it can be seen. */
function millimetres(mm: number): string {
  return `${figure(mm, mm < 10 ? 1 : 0)} mm`;
}

function unproved(found: FindingParams['unproved-folding'] & { count: number }): FindingWords {
  const { count: number, unchecked, pieces: names } = found;
  const hint =
    unchecked === number
      ? `Nadie ha mirado cómo se ${choose(names.length, 'pliega', 'pliegan')} ${pieces(names)}. Las piezas con menos triángulos son más fáciles.`
      : `No se encontró cómo plegar ${pieces(names)} sin que el papel atraviese el papel. El papel se curva, así que muchas veces sale bien igualmente.`;
  const title = `${count(number, 'pieza puede', 'piezas pueden')} ser ${choose(number, 'difícil', 'difíciles')} de plegar`;
  return { title, hint };
}

const findings: VerdictWords['findings'] = {
  unfinished: {
    good: () => 'Cada triángulo está en una pieza',
    bad: ({ count: number }) => ({
      title: `${count(number, 'triángulo no está', 'triángulos no están')} en ninguna pieza`,
      hint: 'La búsqueda se paró demasiado pronto. Pulsa otra vez «Desplegar» y deja que termine.',
    }),
  },
  'run-stopped': {
    good: () => 'La búsqueda llegó a su fin',
    bad: () => ({
      title: 'La búsqueda se paró antes de terminar',
      hint: 'Lo que hay se puede construir. Si la búsqueda termina, quizá salgan plantillas más fáciles.',
    }),
  },
  'overlapping-pieces': {
    good: () => 'Ninguna pieza queda encima de sí misma',
    bad: ({ count: number, pieces: names }) => ({
      title: count(number, 'pieza queda encima de sí misma', 'piezas quedan encima de sí mismas'),
      hint: `Nadie puede recortar ${choose(names.length, 'entera', 'enteras')} ${pieces(names)}.`,
    }),
  },
  'beyond-paper': {
    good: () => 'Cada pieza cabe en su hoja',
    bad: ({ count: number, pieces: names }) => ({
      title: count(number, 'pieza no cabe en su hoja', 'piezas no caben en sus hojas'),
      hint: `La impresora cortaría un trozo de ${pieces(names)}.`,
    }),
  },
  'short-seams': {
    good: () => 'Las aristas para pegar son lo bastante largas para los dedos',
    bad: ({ count: number, median_mm, isRed }) => ({
      title: count(
        number,
        'arista para pegar es demasiado corta',
        'aristas para pegar son demasiado cortas',
      ),
      hint: `La mitad de todas las aristas miden ${millimetres(median_mm)} como mucho: ${
        isRed ? 'demasiado pequeñas para cualquier dedo.' : 'la punta de un dedo necesita 12 mm.'
      }`,
    }),
  },
  'missing-flaps': {
    good: () => 'Casi todas las aristas tienen una pestaña para pegarlas',
    bad: ({ count: number, share }) => ({
      title: count(
        number,
        'arista no tiene pestaña para pegarla',
        'aristas no tienen pestaña para pegarlas',
      ),
      hint: `Es ${percentage(Math.round(100 * share))} de las aristas que necesitan una. ${choose(number, 'Se cierra', 'Se cierran')} con cinta adhesiva o tiras de papel por dentro.`,
    }),
  },
  'missing-numbers': {
    good: () => 'Se ve qué aristas van juntas',
    bad: ({ count: number }) => ({
      title: count(
        number,
        'arista no tiene un número que se pueda leer',
        'aristas no tienen un número que se pueda leer',
      ),
      hint: 'Mira el modelo para ver qué va junto ahí.',
    }),
  },
  'missing-names': {
    good: () => 'Cada pieza dice cuál es',
    bad: ({ count: number, pieces: names }) => ({
      title: count(
        number,
        'pieza no tiene sitio para su letra',
        'piezas no tienen sitio para sus letras',
      ),
      hint: `Escribe por detrás de ${pieces(names)} al ${choose(names.length, 'recortarla', 'recortarlas')}.`,
    }),
  },
  'tiny-pieces': {
    good: () => 'Ninguna pieza es demasiado pequeña',
    bad: ({ count: number, pieces: names }) => ({
      title: count(number, 'pieza mide menos de 10 mm', 'piezas miden menos de 10 mm'),
      hint: `Recorta ${pieces(names)} al final: las cosas tan pequeñas se pierden.`,
    }),
  },
  'weak-necks': {
    good: () => 'Ninguna pieza pende de un hilo',
    bad: ({ count: number, pieces: names }) => ({
      title: `${count(number, 'pieza puede', 'piezas pueden')} romperse por un sitio estrecho`,
      hint: `Pon ahí cinta adhesiva por detrás de ${pieces(names)} antes de plegar.`,
    }),
  },
  'unproved-folding': {
    good: () => 'Cada pieza se puede plegar: se probó desde plana hasta terminada',
    bad: unproved,
  },
  'spare-sheet': {
    good: ({ sheets }) => (sheets === 1 ? 'Todo está en una hoja' : 'Las hojas se aprovechan bien'),
    bad: ({ sheets, percent }) => ({
      title: 'Puedes ahorrar papel',
      hint:
        percent < 15
          ? `Solo se usa ${percentage(percent)} de la última hoja, la número ${figure(sheets)}.`
          : 'Un poco más pequeño, cabe en menos hojas.',
    }),
  },
  'long-building': {
    good: ({ seconds }) => `Se tarda ${building.duration({ seconds })} en montarlo`,
    bad: ({ seconds }) => ({
      title: `Se tarda ${building.duration({ seconds })} en montarlo`,
      hint: 'Cuenta con varios días, o usa menos triángulos.',
    }),
  },
};

/** The verdict in one line; `rows`: how many findings there are to look at. */
function headline({ code }: Conclusion, rows: number): string {
  switch (code) {
    case 'buildable':
      return 'Listo para imprimir';
    case 'hard':
      return `Se puede montar. Mira antes ${count(rows, 'cosa', 'cosas')}`;
    case 'not-buildable':
      return 'No lo imprimas todavía: así nadie puede montarlo';
  }
}

const shapes = { height: 'de alto', width: 'de ancho', depth: 'de fondo' } as const;

/** What a button does that mends something. */
function remedy(mend: Remedy): string {
  switch (mend.kind) {
    case 'size': {
      const size = `Hacerlo de ${figure(mend.mm)} mm ${shapes[mend.side]}`;
      return mend.saves > 0 ? `${size}: ${counted.sheets(mend.saves)} menos` : size;
    }
    case 'sheets':
      return `Hacerlo más pequeño, para ${counted.sheets(mend.sheets)}`;
    case 'faces':
      return `Usar ${counted.triangles(mend.faces)}`;
    case 'strips':
      return 'Añadir tiras para pegar por detrás';
    case 'numbers-on-flaps':
      return 'Poner números en las pestañas';
    case 'again':
      return mend.names.length > 3
        ? `Buscar otra vez ${counted.pieces(mend.names.length)}`
        : `Buscar otra vez ${all(mend.names)}`;
    case 'finish':
      return 'Volver a desplegar hasta el final';
    case 'merge':
      return `Unir ${mend.names.join(' con ')}`;
  }
}

export const verdict: VerdictWords = {
  findings,
  levels: { green: 'Bien:', amber: 'Mira:', red: 'Alto:' },
  headline,
  good: (number) => `${count(number, 'cosa está', 'cosas están')} bien`,
  remedy,
};
