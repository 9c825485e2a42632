import type { DocumentEdit } from './document-edits.js';
import type { JobResult, JobStart, NetEdit, PartEdit, Piece, SavedNet } from './job.js';
import type { PartName } from './job-options.js';

/** Splits a part in so many. */
export function splitting(part: number, into = 2): PartEdit {
  return { parts: [part], into };
}

/** Merges parts that touch. */
export function merging(parts: number[]): PartEdit {
  return { parts, into: 1 };
}

/** What a job needs to change a result. */
export function startFrom(
  { labels, nets }: JobResult,
  partEdits: readonly PartEdit[],
  netEdits: readonly NetEdit[] = [],
): JobStart {
  return { labels, nets, netEdits, partEdits, paper: null };
}

/** The same for a change that leaves all pieces that it does not touch where they are on paper. */
export function startInPlace(
  result: JobResult,
  partEdits: readonly PartEdit[],
  netEdits: readonly NetEdit[] = [],
): JobStart {
  const { scale, sheets } = result;
  const paper = { scale, sheets: sheets.length, sheetWidth: sheets[0]?.width ?? 0 };
  return { ...startFrom(result, partEdits, netEdits), paper };
}

/** Identifies a net by its faces and folds. */
export function netKey({ faces, folds }: SavedNet): string {
  return `${faces.join()}|${folds.join()}`;
}

/**
 * Where the last stage alone begins to make a result again: with the places that its nets had before they were
 * laid down, since a place that is worked out again differs by its rounding.
 *
 * @param start of the job that made it; null if that was a run
 */
export function startAgain({ labels, nets }: JobResult, start: JobStart | null): JobStart {
  const paper = start?.paper ?? null;
  const before = new Map(paper && start!.nets.map((net) => [netKey(net), net.place]));
  const laid = nets.map(({ place: _, ...net }): SavedNet => {
    const place = before.get(netKey(net));
    return place ? { ...net, place } : net;
  });
  return { labels, nets: laid, netEdits: [], partEdits: [], paper };
}

/** The names with another one for a part, or none if it is empty. */
export function renamed(names: readonly PartName[], part: number, name: string): PartName[] {
  const others = names.filter((chosen) => chosen.part !== part);
  return name === '' ? others : [...others, { part, name }].sort((a, b) => a.part - b.part);
}

/** The names after edits of which some give parts others. */
export function renamedBy(
  edits: readonly DocumentEdit[],
  names: readonly PartName[],
): readonly PartName[] {
  return edits.reduce(
    (chosen, edit) => (edit.kind === 'name' ? renamed(chosen, edit.part - 1, edit.text) : chosen),
    names,
  );
}

/** Whether an edit gives a part the name that it has. */
export function isNamed(edit: DocumentEdit, names: readonly PartName[]): boolean {
  if (edit.kind !== 'name') return false;
  const name = names.find(({ part }) => part === edit.part - 1)?.name ?? '';
  return name === edit.text;
}

/** What rounding makes of a place that is kept, in mm and degrees, at most. */
const samePlace = 1e-6;

function isSamePiece(before: Piece, after: Piece): boolean {
  const places = ({ sheet, x, y, angle }: Piece): number[] => [sheet, x, y, angle];
  const others = places(after);
  return (
    before.part === after.part &&
    before.sources.join() === after.sources.join() &&
    places(before).every((value, i) => Math.abs(value - others[i]!) < samePlace)
  );
}

/** Whether a later result has all pieces of an earlier one where they were, so that only names may differ. */
export function isRenaming(before: JobResult, after: JobResult): boolean {
  const { pieces } = before;
  return (
    before.scale === after.scale &&
    pieces.length === after.pieces.length &&
    pieces.every((piece, i) => isSamePiece(piece, after.pieces[i]!))
  );
}
