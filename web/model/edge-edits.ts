import type { DocumentEdit, FlapChoiceSide, LockKind } from './document-edits.js';
import { facesBeside } from './facing.js';
import type { EdgeLock } from './job-options.js';
import type { SheetEdge, SheetEdges } from './sheet-edges.js';

/** What can be done at an edge. */
export type EdgeAction =
  | 'cut'
  | 'join'
  | 'turn-flap'
  | 'both-flaps'
  | 'no-flap'
  | 'usual-flap'
  | 'lock-fold'
  | 'lock-cut'
  | 'lock-free'
  | 'give-face';

/** Where the flaps of a cut are, seen from one of its sides. */
export type FlapPlace = 'here' | 'there' | 'both' | 'none';

/** Where the flaps at a cut are. */
export function flapPlace(edges: SheetEdges, edge: SheetEdge): FlapPlace {
  const partner = edges.partnerOf(edge);
  const [here, there] = [edges.hasFlap(edge), partner !== null && edges.hasFlap(partner)];
  if (here) return there ? 'both' : 'here';
  return there ? 'there' : 'none';
}

/** What an edge is locked as. */
export function lockOf({ name: [v, w] }: SheetEdge, locks: readonly EdgeLock[]): LockKind {
  const own = locks.find(({ from, to }) => (from === v && to === w) || (from === w && to === v));
  return own?.as ?? 'free';
}

type Edits = Map<EdgeAction, DocumentEdit>;

function addLocks(edits: Edits, { name: edge }: SheetEdge, now: LockKind): Edits {
  for (const as of ['fold', 'cut', 'free'] as const) {
    if (as !== now) edits.set(`lock-${as}`, { kind: 'lock', edge, as });
  }
  return edits;
}

/** Hands the face at this side of a cut over to the part at the other side; null within one part. */
function giftAt(edges: SheetEdges, edge: SheetEdge): DocumentEdit | null {
  const { model, pieces } = edges.result;
  const partner = edges.partnerOf(edge);
  const [own, other] = [pieces[edge.piece]!, partner && pieces[partner.piece]!];
  if (!other || other.part === own.part) return null;
  const face = facesBeside(model, edge.name).find((one) => own.sources.includes(one));
  return face === undefined ? null : { kind: 'assign', faces: [face], part: other.part + 1 };
}

/** The flaps of each place as an edit names them: the piece of this side lies at the left of the edge. */
const sideOf = {
  here: 'first',
  there: 'second',
  both: 'both',
} as const satisfies Partial<Record<FlapPlace, FlapChoiceSide>>;

/** Makes the flaps of a cut higher or lower where they are; null without any. */
export function heightEdit(
  edges: SheetEdges,
  edge: SheetEdge,
  height: number,
): DocumentEdit | null {
  const place = flapPlace(edges, edge);
  if (place === 'none') return null;
  return { kind: 'flap', edge: edge.name, side: sideOf[place], height_mm: height };
}

function addFlaps(edits: Edits, { name: edge }: SheetEdge, place: FlapPlace): void {
  const flap = (side: FlapChoiceSide): DocumentEdit => ({ kind: 'flap', edge, side });
  if (place === 'here') edits.set('turn-flap', flap(sideOf.there));
  if (place === 'there') edits.set('turn-flap', flap(sideOf.here));
  if (place !== 'both') edits.set('both-flaps', flap('both'));
  if (place !== 'none') edits.set('no-flap', flap('none'));
  edits.set('usual-flap', flap('auto'));
}

/**
 * The edits for all that can be done at an edge now; an edge at which the model ends has none.
 *
 * @param lock what the edge is locked as: it stays so whatever else is asked for
 */
export function edgeEdits(edges: SheetEdges, edge: SheetEdge, lock: LockKind = 'free'): Edits {
  const { kind, name } = edge;
  const edits: Edits = new Map();
  if (kind === 'border') return edits;
  if (kind !== 'cut') {
    if (lock === 'free') edits.set('cut', { kind: 'cut', edge: name });
    return addLocks(edits, edge, lock);
  }
  if (lock === 'free') edits.set('join', { kind: 'join', edge: name });
  addFlaps(edits, edge, flapPlace(edges, edge));
  const gift = giftAt(edges, edge);
  if (gift && lock === 'free') edits.set('give-face', gift);
  return addLocks(edits, edge, lock);
}
