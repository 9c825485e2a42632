import type { JobResult } from '../model/job.js';
import { baselineOf, type Label } from './label.js';
import { lineStyles, textColour, type LineKind } from './line-style.js';
import type { Point, Segment } from './point.js';
import { drawSheet, type DrawingOptions, type SheetDrawing } from './sheet-drawing.js';

/** The 0.1 micrometre that four decimals keep is far below what any printer or cutter resolves. */
function decimal(value: number): string {
  return String(Number(value.toFixed(4)) + 0);
}

function attributes(values: Record<string, string | number>): string {
  return Object.entries(values)
    .map(([name, value]) => `${name}="${value}"`)
    .join(' ');
}

function strokeOf(kind: LineKind): string {
  const { width, colour, dash } = lineStyles[kind];
  return attributes({
    fill: 'none',
    stroke: colour,
    'stroke-width': width,
    'stroke-linecap': dash.length > 0 ? 'butt' : 'round',
    'stroke-linejoin': 'round',
    ...(dash.length > 0 && { 'stroke-dasharray': dash.join(' ') }),
  });
}

/** Writes one sheet; holds the flip of y, the only change of coordinates on the way into SVG. */
class SheetWriter {
  constructor(private readonly drawing: SheetDrawing) {}

  private at([x, y]: Point): string {
    return `${decimal(x)} ${decimal(this.drawing.height - y)}`;
  }

  private path(kind: LineKind, letter: string, data: string[]): string[] {
    if (data.length === 0) return [];
    return [`<path data-piece="${letter}" ${strokeOf(kind)} d="${data.join('')}"/>`];
  }

  private folds(kind: 'mountain' | 'valley', letter: string, segments: Segment[]): string[] {
    const data = segments.map(([from, to]) => `M${this.at(from)}L${this.at(to)}`);
    return this.path(kind, letter, data);
  }

  cuts(): string[] {
    return this.drawing.pieces.flatMap(({ letter, cuts }) => {
      const data = cuts.map((walk) => `M${walk.map((point) => this.at(point)).join('L')}Z`);
      return this.path('cut', letter, data);
    });
  }

  mountains(): string[] {
    const { pieces } = this.drawing;
    return pieces.flatMap((piece) => this.folds('mountain', piece.letter, piece.mountains));
  }

  valleys(): string[] {
    const { pieces } = this.drawing;
    return pieces.flatMap((piece) => this.folds('valley', piece.letter, piece.valleys));
  }

  private label(letter: string, label: Label): string {
    const [x, y] = baselineOf(label);
    const [left, top] = [decimal(x), decimal(this.drawing.height - y)];
    const turn = decimal(-label.angle);
    const place = attributes({
      x: left,
      y: top,
      fill: textColour,
      'font-family': 'Helvetica, Arial, sans-serif',
      'font-size': label.size,
      'text-anchor': 'middle',
      // About its own place, which stays where x and y say.
      ...(turn !== '0' && { transform: `rotate(${turn} ${left} ${top})` }),
    });
    return `<text data-piece="${letter}" ${place}>${label.text}</text>`;
  }

  guides(): string[] {
    return this.drawing.pieces.flatMap(({ letter, guides }) => {
      const data = guides.map(([from, to]) => `M${this.at(from)}L${this.at(to)}`);
      return this.path('guide', letter, data);
    });
  }

  labels(): string[] {
    return this.drawing.pieces.flatMap(({ letter, labels }) =>
      labels.map((label) => this.label(letter, label)),
    );
  }
}

function group(id: string, content: string[]): string {
  return [`<g id="${id}">`, ...content, '</g>'].join('\n');
}

/**
 * One sheet, counted from 0, as an SVG document at true size: width and height in mm with a viewBox
 * in mm, no style sheet, and no transforms but the turn of a text about its own place. All groups are there, empty or not, in a fixed order, so
 * that cutting programs find the same layers in every file.
 */
export function writeSvg(result: JobResult, sheet: number, options: DrawingOptions = {}): string {
  const drawing = drawSheet(result, sheet, options);
  const [width, height] = [decimal(drawing.width), decimal(drawing.height)];
  const size = attributes({
    width: `${width}mm`,
    height: `${height}mm`,
    viewBox: `0 0 ${width} ${height}`,
  });
  const writer = new SheetWriter(drawing);
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    `<svg xmlns="http://www.w3.org/2000/svg" ${size}>`,
    group('texture', []),
    group('guide', writer.guides()),
    group('flap', []),
    group('fold-mountain', writer.mountains()),
    group('fold-valley', writer.valleys()),
    group('id', writer.labels()),
    group('cut', writer.cuts()),
    '</svg>',
    '',
  ].join('\n');
}
