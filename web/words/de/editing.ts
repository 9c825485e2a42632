/** What is said in German of edges, pieces and parts of a result, and of changes of them. */
import type { Words } from '../words.js';
import { all, choose, count, figure, parts } from './numbers.js';

const edge = ({ number, piece }: { number: string | null; piece: string }): string =>
  number === null ? `Kante von Teil ${piece}` : `Kante ${number}`;

const piecesAre = (number: number): string =>
  number === 1 ? 'Es gibt jetzt 1 Teil' : `Es gibt jetzt ${figure(number)} Teile`;

export const edges: Words['edges'] = {
  ontoFace: (own) => `${edge(own)}: wird auf eine Fläche geklebt`,
  withinPiece: (own) => `${edge(own)}: wird an eine andere Kante von Teil ${own.piece} geklebt`,
  toPiece: (own, other, sheet) =>
    `${edge(own)}: wird an ${other.number ?? `Teil ${other.piece}`}` +
    `${sheet === null ? '' : ` auf Blatt ${figure(sheet)}`} geklebt`,
  border: (piece) => `Kante von Teil ${piece}: Hier endet das Modell`,
  fold: (kind, piece, degrees) =>
    `${kind === 'mountain' ? 'Bergfalte' : 'Talfalte'} von Teil ${piece}, ${figure(degrees)}°`,
  flaps: {
    here: 'Die Lasche ist auf dieser Seite.',
    there: 'Die Lasche ist auf der anderen Seite.',
    both: 'Auf beiden Seiten ist eine Lasche.',
    none: 'Es gibt keine Lasche.',
  },
  locks: {
    fold: 'Festgelegt: wird nie geschnitten.',
    cut: 'Festgelegt: wird immer geschnitten.',
    free: '',
  },
  lockSigns: { fold: 'Nie schneiden', cut: 'Immer schneiden' },
  gift: (piece) => `Diese Fläche an ${piece} geben`,
  opensElsewhere: 'Das Teil öffnet sich dafür an einer anderen Stelle.',
  pieces: (after, before) => `${piecesAre(after)}; vorher waren es ${figure(before)}.`,
  cut: (pieces) => `Geschnitten. ${pieces}`,
  joined: (pieces) => `Zusammengefügt. ${pieces}`,
  noRoomForFlap: 'Auf dieser Seite ist kein Platz für eine Lasche.',
  noRoomForFlaps: 'Für zwei Laschen ist nicht genug Platz.',
  roomForFlap: (height) => `Hier ist nur Platz für ${figure(height)} mm.`,
  notFound: (text) => `Keine Kante und kein Teil heißt ${text}.`,
  place: (title, number, of) => `${title}: ${figure(number)} von ${figure(of)}`,
  show: 'Zeigen',
  showWhat: (title) => `Zeigen: ${title}`,
};

const tooNear = 'so nah am Rand des Blatts, dass es nicht gedruckt wird';

export const pieces: Words['pieces'] = {
  inPlace: (p) =>
    `Teil ${p.name}, ${figure(p.width)} × ${figure(p.height)} mm, auf Blatt ${figure(p.sheet)}`,
  full: (p) =>
    `Teil ${p.name}: ${figure(p.width)} × ${figure(p.height)} mm, Blatt ${figure(p.sheet)}, ${count(p.faces, 'Fläche', 'Flächen')}`,
  cannotStay: (name, other) =>
    `${name} kann hier nicht bleiben: Es läge ${other === null ? tooNear : `auf ${other}`}.`,
  notDropped: (name, other) =>
    `${name} ist wieder da, wo es war. Dort läge es ${other === null ? tooNear : `auf ${other}`}.`,
  noRoom: (name, sheet) =>
    `Auf Blatt ${figure(sheet)} ist kein Platz für ${name}. Schiebe erst ein anderes Teil weg.`,
  laid: {
    kept: (name) => `${name} bleibt jetzt hier, was sich auch sonst bewegt.`,
    moved: (name) => `${name} verschoben.`,
    turned: (name) => `${name} gedreht.`,
  },
  mayMove: (name) => `${name} darf sich wieder bewegen.`,
  staysHere: 'Es bleibt hier.',
  letMove: 'Loslassen',
  keepHere: 'Hier behalten',
  newSheet: 'ein neues',
};

export const partWords: Words['parts'] = {
  split: (number) => (number > 1 ? 'Diese Abschnitte teilen' : 'Diesen Abschnitt teilen'),
  merge: (number) => (number > 2 ? `Diese ${figure(number)} vereinen` : 'Diese zwei vereinen'),
  part: (part) => `Abschnitt ${figure(part)}`,
  nameOf: (part) => `Name von Abschnitt ${figure(part)}`,
  name: 'Name',
  noNet: 'kein Netz',
  pieces: (names) => `${choose(names.length, 'Teil', 'Teile')} ${all(names)}`,
  faces: (faces) => count(faces, 'Fläche', 'Flächen'),
};

const anEdge = (name: string | null): string => name ?? 'einer Kante';
const aPiece = (name: string | null): string => name ?? 'ein Teil';

export const changes: Words['changes'] = {
  undo: (change) => (change === null ? 'Rückgängig' : `Rückgängig: ${change}`),
  redo: (change) => (change === null ? 'Wiederholen' : `Wiederholen: ${change}`),
  split: (numbers) => `${parts(numbers)} geteilt`,
  merge: (numbers) => `${parts(numbers)} vereint`,
  assign: (numbers) => `Flächen an ${parts(numbers)}`,
  again: (numbers) => `anderes Netz für ${parts(numbers)}`,
  name: (numbers) => `Name von ${parts(numbers)}`,
  cut: (piece) => (piece === null ? 'Schnitt' : `Schnitt in ${piece}`),
  join: (piece) => (piece === null ? 'Falte statt Schnitt' : `Falte statt Schnitt in ${piece}`),
  flap: {
    first: (name) => `Lasche von ${anEdge(name)} gewendet`,
    second: (name) => `Lasche von ${anEdge(name)} gewendet`,
    both: (name) => `Laschen auf beiden Seiten von ${anEdge(name)}`,
    none: (name) => `Lasche von ${anEdge(name)} entfernt`,
    auto: (name) => `Lasche von ${anEdge(name)} wie üblich`,
  },
  flapHeight: (edge, height) => `Lasche von ${edge ?? 'einer Kante'} ${figure(height)} mm hoch`,
  pieceFlaps: (piece) => `Laschen von ${piece ?? 'einem Teil'}`,
  lock: (as, name, piece) => {
    const kind = { fold: 'nie schneiden', cut: 'immer schneiden', free: 'frei gegeben' }[as];
    if (name !== null) return `${kind} an ${name}`;
    return piece === null ? kind : `${kind} in ${piece}`;
  },
  paper: {
    size: 'andere Größe',
    strips: 'andere Papierstreifen',
    numbers: 'andere Kantennummern',
    paper: 'anderes Papier',
  },
  look: 'anderes Aussehen',
  unpin: (name) => `${aPiece(name)} losgelassen`,
  place: {
    kept: (name) => `${aPiece(name)} festgehalten`,
    moved: (name) => `${aPiece(name)} verschoben`,
    turned: (name) => `${aPiece(name)} gedreht`,
  },
};
