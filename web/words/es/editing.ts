/** What is said in Spanish of edges, pieces and parts of a result, and of changes of them. */
import type { Words } from '../words.js';
import { all, choose, counted, figure, parts } from './numbers.js';

const edge = ({ number, piece }: { number: string | null; piece: string }): string =>
  number === null ? `Arista de la pieza ${piece}` : `Arista ${number}`;

export const edges: Words['edges'] = {
  ontoFace: (own) => `${edge(own)}: se pega sobre una cara`,
  withinPiece: (own) => `${edge(own)}: se pega a otra arista de la pieza ${own.piece}`,
  toPiece: (own, other, sheet) =>
    `${edge(own)}: se pega a ${other.number ?? `la pieza ${other.piece}`}` +
    (sheet === null ? '' : ` en la hoja ${figure(sheet)}`),
  border: (piece) => `Arista de la pieza ${piece}: aquí termina el modelo`,
  fold: (kind, piece, degrees) =>
    `${kind === 'mountain' ? 'Pliegue en montaña' : 'Pliegue en valle'} de la pieza ${piece}, ${figure(degrees)}°`,
  flaps: {
    here: 'Su pestaña está en este lado.',
    there: 'Su pestaña está en el otro lado.',
    both: 'Tiene pestañas en los dos lados.',
    none: 'No tiene pestaña.',
  },
  locks: {
    fold: 'Fijada: no se corta nunca.',
    cut: 'Fijada: se corta siempre.',
    free: '',
  },
  lockSigns: { fold: 'No se corta nunca', cut: 'Se corta siempre' },
  gift: (piece) => `Dar esta cara a ${piece}`,
  opensElsewhere: 'La pieza se abre por otro sitio.',
  pieces: (after, before) => `Ahora hay ${counted.pieces(after)}; antes había ${figure(before)}.`,
  cut: (pieces) => `Cortado. ${pieces}`,
  joined: (pieces) => `Unido. ${pieces}`,
  noRoomForFlap: 'En ese lado no hay sitio para una pestaña.',
  noRoomForFlaps: 'No hay sitio para dos pestañas.',
  roomForFlap: (height) => `Aquí solo hay sitio para ${figure(height)} mm.`,
  notFound: (text) => `Ninguna arista y ninguna pieza se llama ${text}.`,
  place: (title, number, of) => `${title}: ${figure(number)} de ${figure(of)}`,
  show: 'Mostrar',
  showWhat: (title) => `Mostrar: ${title}`,
};

const tooNear = 'demasiado cerca del borde de la hoja para imprimirse';

export const pieces: Words['pieces'] = {
  inPlace: (p) =>
    `Pieza ${p.name}, ${figure(p.width)} × ${figure(p.height)} mm, en la hoja ${figure(p.sheet)}`,
  full: (p) =>
    `Pieza ${p.name}: ${figure(p.width)} × ${figure(p.height)} mm, hoja ${figure(p.sheet)}, ${counted.faces(p.faces)}`,
  cannotStay: (name, other) =>
    `${name} no puede quedarse aquí: quedaría ${other === null ? tooNear : `encima de ${other}`}.`,
  notDropped: (name, other) =>
    `${name} ha vuelto a su sitio. Allí quedaría ${other === null ? tooNear : `encima de ${other}`}.`,
  noRoom: (name, sheet) =>
    `No hay sitio para ${name} en la hoja ${figure(sheet)}. Aparta antes otra pieza.`,
  laid: {
    kept: (name) => `${name} se queda aquí, aunque se mueva lo demás.`,
    moved: (name) => `${name} se ha movido.`,
    turned: (name) => `${name} se ha girado.`,
  },
  mayMove: (name) => `${name} puede volver a moverse.`,
  staysHere: 'Se queda aquí.',
  letMove: 'Soltar',
  keepHere: 'Dejar aquí',
  newSheet: 'una nueva',
};

export const partWords: Words['parts'] = {
  split: (number) => (number > 1 ? 'Dividir estas partes' : 'Dividir esta parte'),
  merge: (number) => (number > 2 ? `Unir estas ${figure(number)}` : 'Unir estas dos'),
  part: (part) => `Parte ${figure(part)}`,
  nameOf: (part) => `Nombre de la parte ${figure(part)}`,
  name: 'nombre',
  noNet: 'sin plantilla',
  pieces: (names) => `${choose(names.length, 'pieza', 'piezas')} ${all(names)}`,
  faces: counted.faces,
};

const anEdge = (name: string | null): string => name ?? 'una arista';
const aPiece = (name: string | null): string => name ?? 'una pieza';

export const changes: Words['changes'] = {
  undo: (change) => (change === null ? 'Deshacer' : `Deshacer: ${change}`),
  redo: (change) => (change === null ? 'Rehacer' : `Rehacer: ${change}`),
  split: (numbers) => `dividir ${parts(numbers)}`,
  merge: (numbers) => `unir ${parts(numbers)}`,
  assign: (numbers) => `caras dadas a ${parts(numbers)}`,
  again: (numbers) => `otra plantilla para ${parts(numbers)}`,
  name: (numbers) => `nombre de ${parts(numbers)}`,
  cut: (piece) => (piece === null ? 'corte' : `corte en ${piece}`),
  join: (piece) =>
    piece === null ? 'pliegue en vez de corte' : `pliegue en vez de corte en ${piece}`,
  flap: {
    first: (name) => `cambiar de lado la pestaña de ${anEdge(name)}`,
    second: (name) => `cambiar de lado la pestaña de ${anEdge(name)}`,
    both: (name) => `pestañas en los dos lados de ${anEdge(name)}`,
    none: (name) => `quitar la pestaña de ${anEdge(name)}`,
    auto: (name) => `pestaña de ${anEdge(name)} como siempre`,
  },
  flapHeight: (edge, height) => `pestaña de ${edge ?? 'una arista'} de ${figure(height)} mm`,
  pieceFlaps: (piece) => `pestañas de ${piece ?? 'una pieza'}`,
  lock: (as, name, piece) => {
    const kind = { fold: 'no cortar nunca', cut: 'cortar siempre', free: 'dejar libre' }[as];
    if (name !== null) return `${kind} en ${name}`;
    return piece === null ? kind : `${kind} en ${piece}`;
  },
  paper: {
    size: 'cambio de tamaño',
    strips: 'cambio de tiras de papel',
    numbers: 'cambio de números de arista',
    paper: 'cambio de papel',
  },
  look: 'cambio de aspecto',
  unpin: (name) => `soltar ${aPiece(name)}`,
  place: {
    kept: (name) => `dejar ${aPiece(name)} en su sitio`,
    moved: (name) => `mover ${aPiece(name)}`,
    turned: (name) => `girar ${aPiece(name)}`,
  },
};
