import type { DocumentEdit, FlapChoiceSide } from './document-edits.js';
import type { SheetEdge, SheetEdges } from './sheet-edges.js';

/** What can be done at an edge. */
export type EdgeAction = 'cut' | 'join' | 'turn-flap' | 'both-flaps' | 'no-flap' | 'usual-flap';

/** Where the flaps of a cut are, seen from one of its sides. */
export type FlapPlace = 'here' | 'there' | 'both' | 'none';

/** Where the flaps at a cut are. */
export function flapPlace(edges: SheetEdges, edge: SheetEdge): FlapPlace {
  const partner = edges.partnerOf(edge);
  const [here, there] = [edges.hasFlap(edge), partner !== null && edges.hasFlap(partner)];
  if (here) return there ? 'both' : 'here';
  return there ? 'there' : 'none';
}

/** The edits for all that can be done at an edge now; an edge at which the model ends has none. */
export function edgeEdits(edges: SheetEdges, edge: SheetEdge): Map<EdgeAction, DocumentEdit> {
  const { kind, name } = edge;
  if (kind === 'border') return new Map();
  if (kind !== 'cut') return new Map([['cut', { kind: 'cut', edge: name }]]);
  const flap = (side: FlapChoiceSide): DocumentEdit => ({ kind: 'flap', edge: name, side });
  const place = flapPlace(edges, edge);
  const edits = new Map<EdgeAction, DocumentEdit>([['join', { kind: 'join', edge: name }]]);
  // The piece of this side lies at the left of the edge, which is the first one.
  if (place === 'here') edits.set('turn-flap', flap('second'));
  if (place === 'there') edits.set('turn-flap', flap('first'));
  if (place !== 'both') edits.set('both-flaps', flap('both'));
  if (place !== 'none') edits.set('no-flap', flap('none'));
  return edits.set('usual-flap', flap('auto'));
}
