/** Sheets that are chosen, from 0, ascending; null for all of them. */
export type SheetRange = readonly number[] | null;

/** Why a text chooses no sheets. */
export type RangeFault = 'unreadable' | 'beyond';

/**
 * Reads which sheets a person means: "2", "1-3" or "1-3, 5", counted from 1; nothing means all. The ends of a range may
 * stand in any order, and sheets may be named more than once.
 *
 * @param count of all sheets
 */
export function parseSheetRange(text: string, count: number): SheetRange | RangeFault {
  const parts = text.split(/[,;]/).map((part) => part.trim());
  if (parts.every((part) => part === '')) return null;
  const chosen = new Set<number>();
  for (const part of parts.filter(Boolean)) {
    const ends = /^(\d{1,4})(?:\s*[-–]\s*(\d{1,4}))?$/.exec(part);
    if (!ends) return 'unreadable';
    const [from, to] = [Number(ends[1]), Number(ends[2] ?? ends[1])].sort((a, b) => a - b);
    if (from! < 1 || to! > count) return 'beyond';
    for (let sheet = from!; sheet <= to!; ++sheet) chosen.add(sheet - 1);
  }
  return chosen.size === count ? null : [...chosen].sort((a, b) => a - b);
}

export function isRangeFault(range: SheetRange | RangeFault): range is RangeFault {
  return typeof range === 'string';
}
