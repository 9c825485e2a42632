import type { DocumentEdit, FlapChoiceSide, LockKind } from '../model/document-edits.js';
import type { JobResult } from '../model/job.js';
import { layingOf } from '../model/piece-edits.js';
import { printedText, SheetEdges } from '../model/sheet-edges.js';

type Kind = DocumentEdit['kind'];

/** An edit at one edge. */
type EdgeEdit = Extract<DocumentEdit, { kind: 'cut' | 'join' | 'flap' | 'lock' }>;

/** An edit of where one piece lies. */
type PieceEdit = Extract<DocumentEdit, { kind: 'place' | 'unpin' }>;

/** Of the kinds that are about neither parts nor one edge or piece of the result. */
const words: Readonly<
  Record<
    Exclude<
      Kind,
      | 'split'
      | 'merge'
      | 'again'
      | 'assign'
      | 'name'
      | 'paper'
      | EdgeEdit['kind']
      | PieceEdit['kind']
    >,
    string
  >
> = {
  print: 'change of look',
};

const flapWords: Readonly<Record<FlapChoiceSide, (edge: string) => string>> = {
  first: (edge) => `flap of ${edge} turned`,
  second: (edge) => `flap of ${edge} turned`,
  both: (edge) => `flaps on both sides of ${edge}`,
  none: (edge) => `flap of ${edge} taken away`,
  auto: (edge) => `flap of ${edge} as usual`,
};

const lockWords: Readonly<Record<LockKind, string>> = {
  fold: 'never cut',
  cut: 'always cut',
  free: 'lock taken away',
};

/** What an edit of paper changes, by the options that it has; each stands for a kind. */
const paperWords: Readonly<Record<string, string>> = {
  height: 'size',
  width: 'size',
  depth: 'size',
  scale: 'size',
  sheets: 'size',
  glueStrips: 'strips of paper',
  ids: 'edge numbers',
};

/** Names an edit at an edge by what the edge is in a result before or after it. */
function edgeEditWords(edit: EdgeEdit, result: JobResult): string {
  const edge = new SheetEdges(result).find(edit.edge);
  const piece = edge ? result.pieces[edge.piece]!.name : null;
  const number = edge && printedText(edge);
  switch (edit.kind) {
    case 'cut':
      return piece === null ? 'cut' : `cut in ${piece}`;
    case 'join':
      return piece === null ? 'fold made' : `fold made in ${piece}`;
    case 'flap':
      return flapWords[edit.side](number ?? 'an edge');
    case 'lock': {
      const place = number === null ? (piece ? ` in ${piece}` : '') : ` at ${number}`;
      return `${lockWords[edit.as]}${place}`;
    }
  }
}

/** What an edit of where a piece lies does, in the result before it. */
export function pieceEditWords(edit: PieceEdit, result: JobResult): string {
  const piece = result.pieces[edit.piece - 1];
  const name = piece?.name ?? 'a piece';
  if (edit.kind === 'unpin') return `let ${name} move`;
  const place = { sheet: edit.sheet - 1, x: edit.x_mm, y: edit.y_mm, turn: edit.turn_deg };
  const laying = piece ? layingOf(piece, place) : 'moved';
  return laying === 'kept' ? `kept ${name} in place` : `${laying} ${name}`;
}

/** "part 3", "parts 1 and 2"; parts count from 1. */
function partNumbers(parts: readonly number[]): string {
  if (parts.length === 1) return `part ${parts[0]}`;
  return `parts ${parts.slice(0, -1).join(', ')} and ${parts.at(-1)}`;
}

/** The parts that an edit is about by their numbers, from 1. */
export function partsOf(edit: DocumentEdit): readonly number[] {
  if (edit.kind === 'merge') return edit.parts;
  return 'part' in edit ? [edit.part] : [];
}

/**
 * Names edits that are made in one go, to be read after "Undo: ".
 *
 * @param result the one before them, or else after them, in which edges and pieces have their names
 */
export function editWords(edits: readonly DocumentEdit[], result: JobResult): string {
  const [first] = edits;
  if (!first) return '';
  const parts = partNumbers([...new Set(edits.flatMap(partsOf))]);
  switch (first.kind) {
    case 'split':
      return `split of ${parts}`;
    case 'merge':
      return `merging of ${parts}`;
    case 'assign':
      return `faces given to ${parts}`;
    case 'again':
      return `another net for ${parts}`;
    case 'name':
      return `name of ${parts}`;
    case 'cut':
    case 'join':
    case 'flap':
    case 'lock':
      return edgeEditWords(first, result);
    case 'paper': {
      const [option = ''] = Object.keys(first.options);
      return `change of ${paperWords[option] ?? 'paper'}`;
    }
    case 'place':
    case 'unpin':
      return pieceEditWords(first, result);
    default:
      return words[first.kind];
  }
}

/** Parts of the later result, from 0, that have faces of what edits of the earlier one named. */
export function touchedParts(
  before: JobResult,
  after: JobResult,
  edits: readonly DocumentEdit[],
): number[] {
  const pieces = edits.flatMap((edit) => ('piece' in edit ? [before.pieces[edit.piece - 1]!] : []));
  const named = new Set([...edits.flatMap(partsOf), ...pieces.map(({ part }) => part + 1)]);
  return [...new Set(after.labels.filter((_, face) => named.has(before.labels[face]! + 1)))];
}
