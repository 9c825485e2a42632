import type { JobResult, JobStart, NetEdit, PartEdit, PartName } from './job.js';

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

/** The names with another one for a part, or none if it is empty. */
export function renamed(names: readonly PartName[], part: number, name: string): PartName[] {
  const others = names.filter((chosen) => chosen.part !== part);
  return name === '' ? others : [...others, { part, name }].sort((a, b) => a.part - b.part);
}

/** Whether a later result has all pieces of an earlier one where they were, so that only names may differ. */
export function isRenaming(before: JobResult, after: JobResult): boolean {
  const keys = ({ pieces, scale }: JobResult): string =>
    pieces
      .map(({ part, sources, sheet, x, y, angle }) =>
        [scale, part, sheet, x, y, angle, ...sources].join(),
      )
      .join('|');
  return keys(before) === keys(after);
}
