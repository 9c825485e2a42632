/** Texts and pictures on a page, before they are scaled to its paper. */
import type { LineStyle } from '../model/print-options.js';
import type { PictureShape } from './picture-shape.js';
import type { Point } from './point.js';
import type { SheetDrawing } from './sheet-drawing.js';
import { shortened, widthAtMost, type TextLine } from './text-line.js';

/** The shorter side of every page as it is laid out; mm. */
const shortSide = 210;
/** What stays free around, at least and at most. */
const [leastMargin, mostMargin] = [12, 40];

/** A page and what is on it so far. It is laid out on paper with a shorter side of 210 mm. */
export class Page {
  readonly width: number;
  readonly height: number;
  readonly margin: number;
  private readonly factor: number;
  private readonly shapes: PictureShape[] = [];
  private readonly texts: TextLine[] = [];

  /** @param margin that of the sheets; all in mm of the paper */
  constructor(paper: { width: number; height: number }, margin: number) {
    this.factor = Math.min(paper.width, paper.height) / shortSide;
    this.width = paper.width / this.factor;
    this.height = paper.height / this.factor;
    this.margin = Math.min(Math.max(margin / this.factor, leastMargin), mostMargin);
  }

  get isWide(): boolean {
    return this.width > this.height;
  }

  /** Width between the margins. */
  get room(): number {
    return this.width - 2 * this.margin;
  }

  text(text: string, at: Point, size: number, anchor: TextLine['anchor'] = 'start'): void {
    this.texts.push({ text, at, anchor, angle: 0, size });
  }

  /** A text of one line that is shortened where it has no room. */
  line(text: string, at: Point, size: number, room: number): void {
    this.text(shortened(text, size, room), at, size);
  }

  draw(shapes: readonly PictureShape[]): void {
    this.shapes.push(...shapes);
  }

  stroke(style: LineStyle, ...walks: Point[][]): void {
    this.shapes.push({ kind: 'line', style, walks, closed: false });
  }

  /** The page on its paper. */
  drawing(): SheetDrawing {
    const { factor } = this;
    const at = ([x, y]: Point): Point => [factor * x, factor * y];
    const picture = this.shapes.map((shape) => scaled(shape, factor));
    const texts = this.texts.map((text) => ({
      ...text,
      at: at(text.at),
      size: factor * text.size,
    }));
    return {
      width: factor * this.width,
      height: factor * this.height,
      pieces: [],
      frame: { strokes: [], texts },
      picture,
    };
  }
}

function scaled(shape: PictureShape, factor: number): PictureShape {
  const walks = shape.walks.map((walk) => walk.map(([x, y]): Point => [factor * x, factor * y]));
  if (shape.kind === 'area') return { ...shape, walks };
  const { dash, width } = shape.style;
  const style = {
    ...shape.style,
    width: factor * width,
    dash: dash.map((length) => factor * length),
  };
  return { ...shape, style, walks };
}

/** Over the sum of the widths that its letters have at most, a line of a sentence is no wider than this. */
const sentenceShare = 0.91;

/**
 * What stays in one line: a word with the blank before it, or a letter of a script without blanks between words, each
 * with the brackets and stops that belong to it.
 */
const unbroken =
  / *[「（]*(?:[\p{sc=Han}\p{sc=Hira}\p{sc=Kana}]|[^ \p{sc=Han}\p{sc=Hira}\p{sc=Kana}「（、。」）：]+)[ー、。」）：ぁぃぅぇぉっゃゅょァィゥェォッャュョ]*|./gu;

/** A text in lines that have room; a word that has none is shortened. */
export function wrapped(text: string, size: number, room: number): string[] {
  const lines: string[] = [];
  let line = '';
  for (const [word] of text.matchAll(unbroken)) {
    const longer = line === '' ? word.trimStart() : line + word;
    if (sentenceShare * widthAtMost(longer, size) <= room) {
      line = longer;
      continue;
    }
    if (line !== '') lines.push(line);
    line = shortened(word.trimStart(), size, room);
  }
  return line === '' ? lines : [...lines, line];
}
