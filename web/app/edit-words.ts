import type { DocumentEdit } from '../model/document-edits.js';
import type { JobResult } from '../model/job.js';
import { layingOf } from '../model/piece-edits.js';
import { printedText, SheetEdges } from '../model/sheet-edges.js';
import type { Words } from '../words/words.js';

/** An edit at one edge. */
type EdgeEdit = Extract<DocumentEdit, { kind: 'cut' | 'join' | 'flap' | 'lock' }>;

/** An edit of where one piece lies. */
type PieceEdit = Extract<DocumentEdit, { kind: 'place' | 'unpin' }>;

/** What an edit of paper changes, by the options that it has; each stands for a kind. */
const paperKinds: Readonly<Record<string, keyof Words['changes']['paper']>> = {
  height: 'size',
  width: 'size',
  depth: 'size',
  scale: 'size',
  sheets: 'size',
  glueStrips: 'strips',
  ids: 'numbers',
};

/** Names edits at edges by what the first edge is in a result before or after them. */
function edgeEditWords(
  { changes }: Words,
  [edit, ...more]: readonly [EdgeEdit, ...DocumentEdit[]],
  result: JobResult,
): string {
  const edge = new SheetEdges(result).find(edit.edge);
  const piece = edge ? result.pieces[edge.piece]!.name : null;
  const number = edge && printedText(edge);
  switch (edit.kind) {
    case 'cut':
      return changes.cut(piece);
    case 'join':
      return changes.join(piece);
    case 'flap':
      // Only all flaps of a piece change in one go.
      if (more.length > 0) return changes.pieceFlaps(piece);
      return edit.height_mm === undefined
        ? changes.flap[edit.side](number)
        : changes.flapHeight(number, edit.height_mm);
    case 'lock':
      return changes.lock(edit.as, number, piece);
  }
}

/** What an edit of where a piece lies does, in the result before it. */
function pieceEditWords({ changes }: Words, edit: PieceEdit, result: JobResult): string {
  const piece = result.pieces[edit.piece - 1];
  const name = piece?.name ?? null;
  if (edit.kind === 'unpin') return changes.unpin(name);
  const place = { sheet: edit.sheet - 1, x: edit.x_mm, y: edit.y_mm, turn: edit.turn_deg };
  return changes.place[piece ? layingOf(piece, place) : 'moved'](name);
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
export function editWords(words: Words, edits: readonly DocumentEdit[], result: JobResult): string {
  const { changes } = words;
  const [first, ...more] = edits;
  // The model was replaced.
  if (!first) return words.replacing.replaced;
  const parts = [...new Set(edits.flatMap(partsOf))];
  switch (first.kind) {
    case 'split':
    case 'merge':
    case 'assign':
    case 'again':
    case 'name':
      return changes[first.kind](parts);
    case 'cut':
    case 'join':
    case 'flap':
    case 'lock':
      return edgeEditWords(words, [first, ...more], result);
    case 'paper': {
      const [option = ''] = Object.keys(first.options);
      return changes.paper[paperKinds[option] ?? 'paper'];
    }
    case 'place':
    case 'unpin':
      return pieceEditWords(words, first, result);
    case 'print':
      return changes.look;
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
