import type { FontSet } from './font-set.js';
import { missingBox, missingLine, missingWidth } from './missing-sign.js';
import type { Point } from './point.js';
import { directionOf, type TextLine } from './text-line.js';

/** A step of a glyph's outline; the last point is where it ends. */
export interface OutlineStep {
  command: 'M' | 'L' | 'Q' | 'C' | 'Z';
  points: Point[];
}

const commands = {
  moveTo: 'M',
  lineTo: 'L',
  quadraticCurveTo: 'Q',
  bezierCurveTo: 'C',
  closePath: 'Z',
} as const;

function pairs(values: readonly number[]): Point[] {
  return Array.from({ length: values.length / 2 }, (_, i): Point => [
    values[2 * i]!,
    values[2 * i + 1]!,
  ]);
}

/** The frame as two walks, the inner one the other way round. */
function boxSteps(): OutlineStep[] {
  const [left, bottom, right, top] = missingBox;
  const walk = (points: Point[]): OutlineStep[] => [
    ...points.map((point, i): OutlineStep => ({ command: i === 0 ? 'M' : 'L', points: [point] })),
    { command: 'Z', points: [] },
  ];
  return [
    ...walk([
      [left, bottom],
      [right, bottom],
      [right, top],
      [left, top],
    ]),
    ...walk([
      [left + missingLine, bottom + missingLine],
      [left + missingLine, top - missingLine],
      [right - missingLine, top - missingLine],
      [right - missingLine, bottom + missingLine],
    ]),
  ];
}

/** One line of text from its beginning, over the size of the font, and its width. */
function layOut(text: string, fonts: FontSet): { steps: OutlineStep[]; width: number } {
  const steps: OutlineStep[] = [];
  let width = 0;
  const add = (outline: OutlineStep[], scale: number): void => {
    for (const { command, points } of outline) {
      const moved = points.map(([x, y]): Point => [width + x * scale, y * scale]);
      steps.push({ command, points: moved });
    }
  };
  for (const { letters, slice } of fonts.runs(text)) {
    if (slice < 0) {
      add(boxSteps(), 1);
      width += missingWidth;
      continue;
    }
    const font = fonts.font(slice);
    for (const letter of letters) {
      const glyph = font.glyphForCodePoint(letter.codePointAt(0)!);
      const outline = glyph.path.commands.map(({ command, args }) => ({
        command: commands[command],
        points: pairs(args),
      }));
      add(outline, 1 / font.unitsPerEm);
      width += glyph.advanceWidth / font.unitsPerEm;
    }
  }
  return { steps, width };
}

/** A text as outlines where it lies on its sheet, for readers that lack its letters. */
export function outlinesOf(
  { text, at, anchor, angle, size }: TextLine,
  fonts: FontSet,
): OutlineStep[] {
  const { steps, width } = layOut(text, fonts);
  const back = anchor === 'middle' ? width / 2 : 0;
  const [cosine, sine] = directionOf(angle);
  return steps.map(({ command, points }) => ({
    command,
    points: points.map(([x, y]): Point => {
      const along = (x - back) * size;
      return [at[0] + along * cosine - y * size * sine, at[1] + along * sine + y * size * cosine];
    }),
  }));
}

/** Straight pieces of a curve: letters are a few mm high, so they stray by some micrometres. */
const piecesOfCurve = 4;

/** The point at `time` of a Bezier curve, by de Casteljau. */
function onCurve(points: readonly Point[], time: number): Point {
  let left = points;
  while (left.length > 1) {
    left = left.slice(1).map(([x, y], i): Point => {
      const [u, v] = left[i]!;
      return [u + (x - u) * time, v + (y - v) * time];
    });
  }
  return left[0]!;
}

/**
 * Outlines as closed walks of straight lines, for formats without curves.
 *
 * @param pieces of each curve
 */
export function walksOf(steps: readonly OutlineStep[], pieces = piecesOfCurve): Point[][] {
  const walks: Point[][] = [];
  for (const { command, points } of steps) {
    if (command === 'M') walks.push([points[0]!]);
    const walk = walks.at(-1)!;
    if (command === 'L') walk.push(points[0]!);
    if (command !== 'Q' && command !== 'C') continue;
    const curve = [walk.at(-1)!, ...points];
    for (let i = 1; i <= pieces; ++i) walk.push(onCurve(curve, i / pieces));
  }
  return walks;
}
