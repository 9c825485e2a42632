/** Judges what sheets carry besides their pieces: whether it measures right and keeps off them. */
import type { Point, SheetFile, SheetText } from './sheet-file.js';

// What the files' decimals leave open, in mm.
const tolerance = 0.01;

function inkOf({ text, at, angle, size, width }: SheetText): Point[] {
  const turn = (angle * Math.PI) / 180;
  const half = (width ?? 0.55 * size * text.length) / 2;
  const on = (along: number, up: number): Point => [
    at[0] + along * Math.cos(turn) - up * Math.sin(turn),
    at[1] + along * Math.sin(turn) + up * Math.cos(turn),
  ];
  return [
    on(-half, -0.2 * size),
    on(half, -0.2 * size),
    on(half, 0.75 * size),
    on(-half, 0.75 * size),
  ];
}

interface Box {
  low: Point;
  high: Point;
}

function boxOf(points: Point[]): Box {
  const of = (pick: (...values: number[]) => number): Point => [
    pick(...points.map(([x]) => x)),
    pick(...points.map(([, y]) => y)),
  ];
  return { low: of(Math.min), high: of(Math.max) };
}

function isInside([x, y]: Point, walks: Point[][]): boolean {
  let inside = false;
  for (const walk of walks) {
    walk.forEach(([ax, ay], i) => {
      const [bx, by] = walk[(i + 1) % walk.length]!;
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
    });
  }
  return inside;
}

/** Whether a line has a point in a box, by halving it until its parts are short. */
function touches({ low, high }: Box, [ax, ay]: Point, [bx, by]: Point): boolean {
  const apart =
    Math.max(ax, bx) < low[0] ||
    Math.min(ax, bx) > high[0] ||
    Math.max(ay, by) < low[1] ||
    Math.min(ay, by) > high[1];
  if (apart) return false;
  if (Math.hypot(bx - ax, by - ay) < tolerance) return true;
  const middle: Point = [(ax + bx) / 2, (ay + by) / 2];
  return touches({ low, high }, [ax, ay], middle) || touches({ low, high }, middle, [bx, by]);
}

/** Everything of the guide keeps off the pieces and on what is printed. */
function checkPlace(sheet: SheetFile, name: string, least: number): string[] {
  const faults: string[] = [];
  const { strokes, texts } = sheet.guide;
  const things = [
    ...strokes.map((points) => ({ what: 'a line', points })),
    ...texts.map((text) => ({ what: `“${text.text}”`, points: inkOf(text) })),
  ];
  for (const { what, points } of things) {
    const box = boxOf(points);
    const edge = Math.min(...box.low, sheet.width - box.high[0], sheet.height - box.high[1]);
    if (edge < least - tolerance) faults.push(`${name}: ${what} is ${edge} mm from the edge`);
    for (const [letter, { cuts }] of sheet.pieces) {
      const isOn =
        isInside(points[0]!, cuts) ||
        cuts.some((walk) =>
          walk.some((from, i) => touches(box, from, walk[(i + 1) % walk.length]!)),
        );
      if (isOn) faults.push(`${name}: ${what} is on ${letter}`);
    }
  }
  return faults;
}

/** Lengths along x and y of all lines, the box's sides among them. */
function extents({ guide }: SheetFile): Point[] {
  return guide.strokes.map((points) => {
    const { low, high } = boxOf(points);
    return [high[0] - low[0], high[1] - low[1]];
  });
}

/**
 * Everything that is wrong with the guides of all sheets of a run.
 *
 * @param sheets in any order
 * @param margin that was asked for; mm
 * @param factors by which a printer's error is corrected, across and up
 */
export function checkGuides(
  sheets: SheetFile[],
  margin: number,
  factors: Point = [1, 1],
): string[] {
  const faults: string[] = [];
  const numbers = new Set<string>();
  for (const sheet of sheets) {
    const note = sheet.guide.texts.find(({ text }) => text.includes('print at 100 %'))?.text ?? '';
    const [name = 'a sheet', number] = /^sheet (\d+) of \d+/.exec(note) ?? [];
    numbers.add(`${number} of ${sheets.length}`);
    if (!note.includes(`of ${sheets.length} ·`)) faults.push(`${name}: ${note} is no page number`);
    const says = (words: string): boolean => sheet.guide.texts.some(({ text }) => text === words);
    if (!says('this side') || !says('is outside')) faults.push(`${name}: no outside`);
    const isThere = ([x, y]: Point): boolean =>
      extents(sheet).some(([u, v]) => Math.abs(u - x) < tolerance && Math.abs(v - y) < tolerance);
    if (!isThere([50 * factors[0], 0])) faults.push(`${name}: no ruler across`);
    if (!isThere([0, 50 * factors[1]])) faults.push(`${name}: no ruler up`);
    if (!isThere([20 * factors[0], 5 * factors[1]])) faults.push(`${name}: no box`);
    if (factors.every((factor) => factor === 1)) {
      faults.push(...checkPlace(sheet, name, Math.min(margin, 4)));
    }
  }
  if (numbers.size !== sheets.length) faults.push('sheets have the same numbers');
  return faults;
}
