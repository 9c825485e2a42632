import { escaped } from '../model/markup.js';
import type { LineKind, LineStyle } from '../model/print-options.js';
import type { FontSet } from './font-set.js';
import { layers, layerTitles, type Layer } from './layers.js';
import { guideStyle, leaderStyle, penStyle, type Look } from './line-style.js';
import { outlinesOf } from './outlines.js';
import { isPictured, type PlacedImage } from './ground-shape.js';
import { edgeStyle, type PictureShape } from './picture-shape.js';
import { base64 } from './texture/base64.js';
import type { Point, Segment } from './point.js';
import { isPlain, type Print } from './print.js';
import { rimColour, textRimWidth } from './rims.js';
import type { PieceDrawing, SheetDrawing } from './sheet-drawing.js';
import { underlineOf, type TextLine } from './text-line.js';

/** The 0.1 micrometre that four decimals keep is far below what any printer or cutter resolves. */
function decimal(value: number): string {
  return String(Number(value.toFixed(4)) + 0);
}

function attributes(values: Record<string, string | number>): string {
  return Object.entries(values)
    .map(([name, value]) => `${name}="${value}"`)
    .join(' ');
}

function strokeOf({ width, colour, dash }: LineStyle, fill = 'none'): string {
  return attributes({
    fill,
    stroke: colour,
    'stroke-width': width,
    'stroke-linecap': dash.length > 0 ? 'butt' : 'round',
    'stroke-linejoin': 'round',
    ...(dash.length > 0 && { 'stroke-dasharray': dash.join(' ') }),
  });
}

/** Letters on pictures have light rims; nothing but these is drawn below them. */
const textRim = attributes({
  stroke: rimColour,
  'stroke-width': textRimWidth,
  'stroke-linejoin': 'round',
  'paint-order': 'stroke',
});

/**
 * What texts become: text where every reader has its letters, or outlines of all letters, either
 * filled or as lines for a pen.
 */
export type TextForm = 'text' | 'filled' | 'drawn';

/** Writes one sheet; holds the flip of y, the only change of coordinates on the way into SVG. */
class SheetWriter {
  constructor(
    private readonly drawing: SheetDrawing,
    private readonly look: Look,
    private readonly fonts: FontSet | null,
    private readonly texts: TextForm,
  ) {}

  private at([x, y]: Point): string {
    return `${decimal(x)} ${decimal(this.drawing.height - y)}`;
  }

  private walk(points: Point[], closed: boolean): string {
    return `M${points.map((point) => this.at(point)).join('L')}${closed ? 'Z' : ''}`;
  }

  private path(letter: string, paint: string, data: string[]): string[] {
    if (data.length === 0) return [];
    return [`<path data-piece="${escaped(letter)}" ${paint} d="${data.join('')}"/>`];
  }

  /** One path for each piece. */
  private paths(paint: string, dataOf: (piece: PieceDrawing) => string[]): string[] {
    return this.drawing.pieces.flatMap((piece) => this.path(piece.letter, paint, dataOf(piece)));
  }

  private folds(kind: LineKind, segmentsOf: (piece: PieceDrawing) => Segment[]): string[] {
    return this.paths(strokeOf(this.look.lines[kind]), (piece) =>
      segmentsOf(piece).map((segment) => this.walk(segment, false)),
    );
  }

  /** What is drawn in a layer; nothing where it is empty. */
  layer(layer: Layer): string[] {
    switch (layer) {
      case 'texture':
        return this.grounds();
      case 'registration':
        return this.registration();
      case 'guide':
        return [...this.picture(), ...this.guide()];
      case 'flap':
        return this.flaps();
      case 'fold-mountain':
        return this.folds('mountain', ({ mountains }) => mountains);
      case 'fold-valley':
        return this.folds('valley', ({ valleys }) => valleys);
      case 'id':
        return this.labels();
      case 'cut':
        return this.cuts();
    }
  }

  private grounds(): string[] {
    return this.drawing.pieces.flatMap(({ letter, ground }) =>
      ground.map((shape) =>
        shape.kind === 'image' ? this.image(shape, letter) : this.shape(shape, letter),
      ),
    );
  }

  private image({ corners, image }: PlacedImage, letter: string): string {
    const [[left, bottom], [right, top]] = corners;
    const place = attributes({
      x: decimal(left),
      y: decimal(this.drawing.height - top),
      width: decimal(right - left),
      height: decimal(top - bottom),
      // A printer's corrections may stretch it.
      preserveAspectRatio: 'none',
    });
    // Programs for drawing know the older name of the address only.
    const address = `xlink:href="data:image/png;base64,${base64(image.png())}"`;
    return `<image data-piece="${escaped(letter)}" ${place} ${address}/>`;
  }

  private registration(): string[] {
    const { registration } = this.drawing;
    if (!registration) return [];
    const { square, corners, width } = registration;
    const lines = attributes({ fill: 'none', stroke: '#000000', 'stroke-width': width });
    return [
      `<path fill="#000000" d="${this.walk(square, true)}"/>`,
      `<path ${lines} d="${corners.map((corner) => this.walk(corner, false)).join('')}"/>`,
    ];
  }

  private cuts(): string[] {
    return this.paths(strokeOf(this.look.lines.cut), ({ cuts }) =>
      cuts.map((walk) => this.walk(walk, true)),
    );
  }

  private flaps(): string[] {
    const fill = this.look.flaps;
    if (fill === 'none') return [];
    return this.paths(attributes({ fill }), ({ flaps }) =>
      flaps.map((walk) => this.walk(walk, true)),
    );
  }

  private outlinePaint(): string {
    if (this.texts === 'drawn') return strokeOf(penStyle(this.look));
    return attributes({ fill: this.look.text });
  }

  /** Letters that not every reader has are drawn as what they look like. */
  private text(line: TextLine, owner: string, rim = ''): string {
    if (this.fonts && (this.texts !== 'text' || !isPlain(line.text))) {
      const data = outlinesOf(line, this.fonts)
        .map(({ command, points }) => command + points.map((point) => this.at(point)).join(' '))
        .join('');
      const text = attributes({ 'data-text': escaped(line.text) });
      return `<path ${owner}${text} ${this.outlinePaint()}${rim} d="${data}"/>`;
    }
    const [left, top] = this.at(line.at).split(' ');
    const turn = decimal(-line.angle);
    const place = attributes({
      x: left!,
      y: top!,
      fill: this.look.text,
      'font-family': 'Helvetica, Arial, sans-serif',
      'font-size': decimal(line.size),
      'text-anchor': line.anchor,
      // About its own place, which stays where x and y say.
      ...(turn !== '0' && { transform: `rotate(${turn} ${left} ${top})` }),
    });
    return `<text ${owner}${place}${rim}>${escaped(line.text)}</text>`;
  }

  private label(line: TextLine, owner: string, rim: string): string[] {
    const text = this.text(line, owner, rim);
    if (!line.underlined) return [text];
    const { line: segment, width } = underlineOf(line);
    const style =
      this.texts === 'drawn'
        ? penStyle(this.look)
        : { width: Number(decimal(width)), colour: this.look.text, dash: [] };
    return [text, `<path ${owner}${strokeOf(style)} d="${this.walk(segment, false)}"/>`];
  }

  private labels(): string[] {
    return this.drawing.pieces.flatMap((piece) => {
      const owner = `data-piece="${escaped(piece.letter)}" `;
      const rim = isPictured(piece) && this.texts !== 'drawn' ? ` ${textRim}` : '';
      return piece.texts.flatMap((line) => this.label(line, owner, rim));
    });
  }

  private guide(): string[] {
    const { strokes, texts } = this.drawing.frame;
    const kinds = ['flap', undefined, 'mountain', 'valley', 'cut'] as const;
    const paths = kinds.flatMap((kind) => {
      const data = strokes
        .filter(({ sample }) => sample === kind)
        .map(({ points, closed }) => this.walk(points, closed));
      const isNothing = data.length === 0 || (kind === 'flap' && this.look.flaps === 'none');
      return isNothing ? [] : [`<path ${this.guidePaint(kind)} d="${data.join('')}"/>`];
    });
    const leaders = this.paths(strokeOf(leaderStyle(this.look)), ({ guides }) =>
      guides.map((segment) => this.walk(segment, false)),
    );
    return [...paths, ...texts.map((line) => this.text(line, '')), ...leaders];
  }

  /** What a page shows of the model. */
  private picture(): string[] {
    return (this.drawing.picture ?? []).map((shape) => this.shape(shape));
  }

  private shape(shape: PictureShape, letter?: string): string {
    const isLine = shape.kind === 'line';
    const data = shape.walks.map((walk) => this.walk(walk, !isLine || shape.closed)).join('');
    const paint = isLine ? strokeOf(shape.style) : strokeOf(edgeStyle(shape.colour), shape.colour);
    const owner = letter === undefined ? '' : `data-piece="${escaped(letter)}" `;
    return `<path ${owner}${paint} d="${data}"/>`;
  }

  private guidePaint(kind: LineKind | 'flap' | undefined): string {
    if (kind === 'flap') return attributes({ fill: this.look.flaps });
    return strokeOf(kind ? this.look.lines[kind] : guideStyle(this.look));
  }
}

const namespaces = {
  xmlns: 'http://www.w3.org/2000/svg',
  'xmlns:inkscape': 'http://www.inkscape.org/namespaces/inkscape',
};

/** Of the addresses of images. */
const imageNamespace = { 'xmlns:xlink': 'http://www.w3.org/1999/xlink' };

/** A group that Inkscape lists as a layer by its title; nothing if it is empty. */
function group(id: Layer, content: string[]): string[] {
  if (content.length === 0) return [];
  const title = layerTitles[id];
  const layer = attributes({ id, 'inkscape:groupmode': 'layer', 'inkscape:label': title });
  return [`<g ${layer}>`, ...content, '</g>'];
}

/**
 * One sheet, counted from 0, as an SVG document of this width, height and viewBox (in mm).
 *
 * @param texts what becomes of texts; outlines need the print's fonts
 */
export function drawSvg(
  { sheets, look, fonts }: Pick<Print, 'sheets' | 'look' | 'fonts'>,
  sheet: number,
  size: { width: string; height: string; viewBox: string },
  texts: TextForm,
): string {
  const writer = new SheetWriter(sheets[sheet]!, look, fonts, texts);
  const spaces = { ...namespaces, ...(sheets[sheet]!.pieces.some(isPictured) && imageNamespace) };
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    `<svg ${attributes({ ...spaces, ...size })}>`,
    ...layers.flatMap((layer) => group(layer, writer.layer(layer))),
    '</svg>',
    '',
  ].join('\n');
}

/**
 * One sheet, counted from 0, as an SVG document at true size: width and height in mm with a viewBox
 * in mm, no style sheet, and no transforms but the turn of a text about its own place. Groups come
 * in a fixed order, without those that are empty, and are layers in Inkscape. Texts are text, but
 * for letters that not every reader has: those are outlines. For machines all texts are lines.
 */
export function writeSvg(print: Print, sheet: number): string {
  const [width, height] = [print.sheets[sheet]!.width, print.sheets[sheet]!.height].map(decimal);
  const size = { width: `${width}mm`, height: `${height}mm`, viewBox: `0 0 ${width} ${height}` };
  return drawSvg(print, sheet, size, print.machine === 'none' ? 'text' : 'drawn');
}
