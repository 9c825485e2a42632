/** What is said in French of edges, pieces and parts of a result, and of changes of them. */
import type { Words } from '../words.js';
import { all, choose, count, figure, ofParts, parts } from './numbers.js';

const edge = ({ number, piece }: { number: string | null; piece: string }): string =>
  number === null ? `Arête de la pièce ${piece}` : `Arête ${number}`;

export const edges: Words['edges'] = {
  ontoFace: (own) => `${edge(own)}\u202f: collée sur une face`,
  withinPiece: (own) => `${edge(own)}\u202f: collée à une autre arête de la pièce ${own.piece}`,
  toPiece: (own, other, sheet) =>
    `${edge(own)}\u202f: collée à ${other.number ?? `la pièce ${other.piece}`}` +
    (sheet === null ? '' : ` sur la feuille ${figure(sheet)}`),
  border: (piece) => `Arête de la pièce ${piece}\u202f: le modèle s’arrête ici`,
  fold: (kind, piece, degrees) =>
    `${kind === 'mountain' ? 'Pli montagne' : 'Pli vallée'} de la pièce ${piece}, ${figure(degrees)}°`,
  flaps: {
    here: 'Sa languette est de ce côté.',
    there: 'Sa languette est de l’autre côté.',
    both: 'Elle a des languettes des deux côtés.',
    none: 'Elle n’a pas de languette.',
  },
  locks: {
    fold: 'Verrouillée\u202f: jamais coupée.',
    cut: 'Verrouillée\u202f: toujours coupée.',
    free: '',
  },
  lockSigns: { fold: 'Ne jamais couper', cut: 'Toujours couper' },
  gift: (piece) => `Donner cette face à ${piece}`,
  opensElsewhere: 'À la place, la pièce s’ouvre à un autre endroit.',
  pieces: (after, before) =>
    `Il y a maintenant ${count(after, 'pièce', 'pièces')}\u202f; avant, il y en avait ${figure(before)}.`,
  cut: (pieces) => `Coupé. ${pieces}`,
  joined: (pieces) => `Assemblé. ${pieces}`,
  noRoomForFlap: 'Il n’y a pas de place pour une languette de ce côté.',
  noRoomForFlaps: 'Il n’y a pas assez de place pour deux languettes.',
  roomForFlap: (height) => `Il n’y a de place ici que pour ${figure(height)} mm.`,
  notFound: (text) => `Aucune arête et aucune pièce ne s’appelle ${text}.`,
  place: (title, number, of) => `${title}\u202f: ${figure(number)} sur ${figure(of)}`,
  show: 'Montrer',
  showWhat: (title) => `Montrer\u202f: ${title}`,
};

const tooNear = 'trop près du bord de la feuille pour être imprimée';

export const pieces: Words['pieces'] = {
  inPlace: (p) =>
    `Pièce ${p.name}, ${figure(p.width)} × ${figure(p.height)} mm, sur la feuille ${figure(p.sheet)}`,
  full: (p) =>
    `Pièce ${p.name}\u202f: ${figure(p.width)} × ${figure(p.height)} mm, feuille ${figure(p.sheet)}, ${count(p.faces, 'face', 'faces')}`,
  cannotStay: (name, other) =>
    `${name} ne peut pas rester ici\u202f: elle serait ${other === null ? tooNear : `sur ${other}`}.`,
  notDropped: (name, other) =>
    `${name} est revenue à sa place. Là-bas, elle serait ${other === null ? tooNear : `sur ${other}`}.`,
  noRoom: (name, sheet) =>
    `Il n’y a pas de place pour ${name} sur la feuille ${figure(sheet)}. Écarte d’abord une autre pièce.`,
  laid: {
    kept: (name) => `${name} reste maintenant ici, même si le reste bouge.`,
    moved: (name) => `${name} est déplacée.`,
    turned: (name) => `${name} est tournée.`,
  },
  mayMove: (name) => `${name} peut à nouveau bouger.`,
  staysHere: 'Elle reste ici.',
  letMove: 'Libérer',
  keepHere: 'Garder ici',
  newSheet: 'une nouvelle',
};

export const partWords: Words['parts'] = {
  split: (number) => (number > 1 ? 'Diviser ces parties' : 'Diviser cette partie'),
  merge: (number) => (number > 2 ? `Réunir ces ${figure(number)}` : 'Réunir ces deux'),
  part: (part) => `Partie ${figure(part)}`,
  nameOf: (part) => `Nom de la partie ${figure(part)}`,
  name: 'nom',
  noNet: 'pas de patron',
  pieces: (names) => `${choose(names.length, 'pièce', 'pièces')} ${all(names)}`,
  faces: (faces) => count(faces, 'face', 'faces'),
};

const ofEdge = (name: string | null): string =>
  name === null ? 'd’une arête' : `de l’arête ${name}`;
const aPiece = (name: string | null): string => name ?? 'une pièce';

export const changes: Words['changes'] = {
  undo: (change) => (change === null ? 'Annuler' : `Annuler\u202f: ${change}`),
  redo: (change) => (change === null ? 'Rétablir' : `Rétablir\u202f: ${change}`),
  split: (numbers) => `division ${ofParts(numbers)}`,
  merge: (numbers) => `réunion ${ofParts(numbers)}`,
  assign: (numbers) => `faces pour ${parts(numbers)}`,
  again: (numbers) => `autre patron pour ${parts(numbers)}`,
  name: (numbers) => `nom ${ofParts(numbers)}`,
  cut: (piece) => (piece === null ? 'coupe' : `coupe dans ${piece}`),
  join: (piece) => (piece === null ? 'pli ajouté' : `pli ajouté dans ${piece}`),
  flap: {
    first: (name) => `languette ${ofEdge(name)} retournée`,
    second: (name) => `languette ${ofEdge(name)} retournée`,
    both: (name) => `languettes des deux côtés ${ofEdge(name)}`,
    none: (name) => `languette ${ofEdge(name)} enlevée`,
    auto: (name) => `languette ${ofEdge(name)} comme d’habitude`,
  },
  flapHeight: (edge, height) => `languette de ${edge ?? 'une arête'} haute de ${figure(height)} mm`,
  pieceFlaps: (piece) => `languettes de ${piece ?? 'une pièce'}`,
  lock: (as, name, piece) => {
    const kind = { fold: 'ne jamais couper', cut: 'toujours couper', free: 'verrou enlevé' }[as];
    if (name !== null) return `${kind} à l’arête ${name}`;
    return piece === null ? kind : `${kind} dans ${piece}`;
  },
  paper: {
    size: 'autre taille',
    strips: 'autres bandes de papier',
    numbers: 'autres numéros d’arêtes',
    paper: 'autre papier',
  },
  look: 'autre aspect',
  unpin: (name) => `${aPiece(name)} libérée`,
  place: {
    kept: (name) => `${aPiece(name)} gardée en place`,
    moved: (name) => `${aPiece(name)} déplacée`,
    turned: (name) => `${aPiece(name)} tournée`,
  },
};
