/** A line of a ruler. */
export interface Tick {
  /** mm. */
  at: number;
  /** Pixels from the beginning of the ruler. */
  pixel: number;
  /** Whether it has a number. */
  isMain: boolean;
}

/** mm between lines with numbers, of which the first is taken that leaves room for them. */
const steps = [1, 2, 5, 10, 20, 50, 100, 200, 500] as const;

/** Pixels that a number needs. */
const numberRoom = 34;

/** Pixels between lines at least. */
const lineRoom = 4;

/** mm from one number to the next, and how many spaces there are between them. */
export function rulerStep(pixelsPerMm: number): { main: number; parts: number } {
  const main = steps.find((step) => step * pixelsPerMm >= numberRoom) ?? steps.at(-1)!;
  const parts = [10, 5, 2, 1].find((count) => (main * pixelsPerMm) / count >= lineRoom) ?? 1;
  return { main, parts };
}

/**
 * The lines of a ruler along the screen.
 *
 * @param zero where its 0 is, in pixels from its beginning; may lie outside
 * @param length pixels
 */
export function rulerTicks(zero: number, pixelsPerMm: number, length: number): Tick[] {
  const { main, parts } = rulerStep(pixelsPerMm);
  const fine = main / parts;
  const first = Math.ceil(-zero / (fine * pixelsPerMm));
  const last = Math.floor((length - zero) / (fine * pixelsPerMm));
  const ticks: Tick[] = [];
  for (let i = first; i <= last; ++i) {
    // Whole numbers are counted, so no error adds up.
    ticks.push({ at: i * fine, pixel: zero + i * fine * pixelsPerMm, isMain: i % parts === 0 });
  }
  return ticks;
}
