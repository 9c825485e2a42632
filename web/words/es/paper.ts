/** Spanish phrases for what is told of sheets before they are printed: what they lack, and what is hard to build. */
import type { Messages, Table } from '../messages.js';
import { choose, count, counted, figure, percentage, pieces, some } from './numbers.js';

/** Why seams have no flap. */
const misses = {
  narrow: 'en cuñas demasiado estrechas para una',
  thin: 'donde la cara vecina es demasiado delgada para tapar una',
  blocked: 'donde estorba otra cosa de la pieza',
  short: 'por falta de largo',
} as const;

function missingFlaps(params: Messages['missing-flaps']): string {
  const kinds = (Object.keys(misses) as (keyof typeof misses)[]).filter((kind) => params[kind] > 0);
  const reasons = kinds.map((kind) => `${figure(params[kind])} ${misses[kind]}`).join(', ');
  const strips =
    params.strips > 0
      ? `${figure(params.strips)} ${choose(params.strips, 'lleva', 'llevan')} en su lugar una tira suelta, para otras basta con cinta adhesiva`
      : 'ciérralas con cinta adhesiva o tiras de papel por dentro';
  return (
    `sin pestaña en ${counted.seams(params.count)} de ${pieces(params.pieces)}: ${reasons}. ` +
    `Es ${percentage(params.percent)} del largo de todas las uniones; ${strips}`
  );
}

/** Why pictures are not printed, and what helps. */
const pictureFaults = {
  format: ['no es una imagen PNG, JPEG o GIF', 'no son imágenes PNG, JPEG o GIF'],
  damaged: ['está dañada o no se ve nada en ella', 'están dañadas o no se ve nada en ellas'],
  large: [
    'es demasiado grande, guárdala con menos píxeles',
    'son demasiado grandes, guárdalas con menos píxeles',
  ],
} as const;

function picturesUnreadable({ what, files }: Messages['pictures-unreadable']): string {
  const [one, many] = pictureFaults[what];
  return `${some(files)} ${choose(files.length, one, many)}: sus caras llevan el color de su material`;
}

/** So many numbers are looked for one by one; of more it is told where most of them are. */
const mostNumbers = 30;
const mostPlaces = 8;

/** "A: 3, 12; A-C: 1", or "40 en A, 7 en A-C y 5 en otros sitios". */
function seamList(seams: readonly string[]): string {
  const numbers = new Map<string, string[]>(); // by the pieces that meet there
  for (const seam of seams) {
    const [names, number] = seam.split(':') as [string, string];
    numbers.set(names, [...(numbers.get(names) ?? []), number]);
  }
  if (seams.length <= mostNumbers) {
    return [...numbers].map(([names, all]) => `${names}: ${all.join(', ')}`).join('; ');
  }
  const most = [...numbers].sort(([, a], [, b]) => b.length - a.length).slice(0, mostPlaces);
  const places = most.map(([names, all]) => `${figure(all.length)} en ${names}`).join(', ');
  const others = most.reduce((rest, [, all]) => rest - all.length, seams.length);
  return others > 0 ? `${places} y ${figure(others)} en otros sitios` : places;
}

function shortSeams({ median_mm, faces, ...size }: Messages['short-seams']): string {
  const words = { height: 'de alto', width: 'de ancho', depth: 'de fondo' } as const;
  const better = (Object.keys(words) as (keyof typeof words)[]).flatMap((side) => {
    const mm = size[side];
    return mm === undefined ? [] : [`${figure(mm)} mm ${words[side]} (--${side} ${mm})`];
  });
  if (faces !== undefined) {
    better.push(`simplificado a ${counted.faces(faces)} (--faces ${faces})`);
  }
  const easier = better.length > 0 ? `; más fácil de montar: ${better.join(', o ')}` : '';
  return `la mitad de las uniones miden ${figure(median_mm, 1)} mm de largo como mucho, y eso es difícil de pegar${easier}`;
}

export const paperMessages = {
  'no-looks': () => 'el modelo no tiene colores ni imágenes que se puedan imprimir',
  'pictures-unreadable': picturesUnreadable,
  'pictures-not-loaded': () =>
    'lo que lee las imágenes no se pudo cargar: las caras llevan los colores de sus materiales',
  'missing-names': ({ pieces: names }) =>
    `no hay sitio para ${choose(names.length, 'el nombre', 'los nombres')} en ${pieces(names)}; los nombres cortos ocupan menos`,
  'missing-flaps': missingFlaps,
  'missing-numbers': ({ seams }) =>
    `no hay sitio para un número que se lea a los dos lados de ${counted.seams(seams.length)}: ${seamList(seams)}`,
  'overlapping-pieces': ({ pieces: names }) =>
    `${pieces(names)} ${choose(names.length, 'se solapa consigo misma y no se puede recortar entera', 'se solapan consigo mismas y no se pueden recortar enteras')}`,
  'short-seams': shortSeams,
  'empty-sheet': ({ sheet, percent, pieces: names }) =>
    `la última hoja, la número ${figure(sheet)}, está casi vacía: se usa ${percentage(percent)} de ella` +
    (names.length > 0 ? `, para ${pieces(names)}` : ', para tiras sueltas'),
  'tiny-pieces': ({ pieces: names }) =>
    `${pieces(names)} ${choose(names.length, 'mide menos de 10 mm y se pierde con facilidad: recórtala', 'miden menos de 10 mm y se pierden con facilidad: recórtalas')} al final`,
  'equal-pieces': ({ pieces: names }) =>
    `la misma pieza hace falta ${count(names.length, 'vez', 'veces')}: ${pieces(names)}`,
} satisfies Partial<Table>;
