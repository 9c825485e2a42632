/** Share of a room in percent that what is on its left has. */
export const splitRange = { least: 20, most: 70, usual: 40 } as const;

/** Percent of one press of an arrow key, and of one with Shift. */
const steps = { plain: 2, shift: 10 } as const;

export function clampedSplit(share: number): number {
  if (!Number.isFinite(share)) return splitRange.usual;
  return Math.min(Math.max(share, splitRange.least), splitRange.most);
}

/** The share when the border is drawn to a place. */
export function splitAt(x: number, room: { left: number; width: number }): number {
  return clampedSplit((100 * (x - room.left)) / room.width);
}

/** The share after a key; null for keys that move no border. */
export function splitAfterKey(share: number, key: string, isFar: boolean): number | null {
  const step = isFar ? steps.shift : steps.plain;
  switch (key) {
    case 'ArrowLeft':
      return clampedSplit(share - step);
    case 'ArrowRight':
      return clampedSplit(share + step);
    case 'Home':
      return splitRange.least;
    case 'End':
      return splitRange.most;
    case 'Enter':
      return splitRange.usual;
    default:
      return null;
  }
}
