import {
  beginMarkedContent,
  beginText,
  closePath,
  endMarkedContent,
  endText,
  fill,
  fillAndStroke,
  lineTo,
  moveTo,
  PDFDocument,
  popGraphicsState,
  PrintScaling,
  pushGraphicsState,
  rgb,
  setDashPattern,
  setFillingColor,
  setFontAndSize,
  setLineCap,
  setLineJoin,
  setLineWidth,
  setStrokingColor,
  setTextMatrix,
  showText,
  stroke,
  type PDFOperator,
  type PDFPage,
} from 'pdf-lib';
import type { LineStyle } from '../model/print-options.js';
import { FontSet } from './font-set.js';
import { guideStyle, leaderStyle, type Look } from './line-style.js';
import { missingBox, missingLine, missingWidth } from './missing-sign.js';
import { PdfFonts } from './pdf-fonts.js';
import { edgeStyle, type PictureShape } from './picture-shape.js';
import type { Point } from './point.js';
import { textsOf, type Print } from './print.js';
import type { PieceDrawing, SheetDrawing } from './sheet-drawing.js';
import { directionOf, type TextLine } from './text-line.js';

/** A length in points; a ten-thousandth of a point is far below what any printer resolves. */
function points(millimetres: number): number {
  return Math.round((millimetres * 72e4) / 25.4) / 1e4;
}

function colour(hex: string): ReturnType<typeof rgb> {
  const channel = (at: number): number => Number.parseInt(hex.slice(at, at + 2), 16) / 255;
  return rgb(channel(1), channel(3), channel(5));
}

function path(walk: readonly Point[], closed: boolean): PDFOperator[] {
  const steps = walk.map(([x, y], i) => (i === 0 ? moveTo : lineTo)(points(x), points(y)));
  return closed ? [...steps, closePath()] : steps;
}

/** Operators are handed over as arguments, of which there may not be too many. */
const mostWalks = 5000;

/** Writes one sheet on its page. */
class PageWriter {
  constructor(
    private readonly page: PDFPage,
    private readonly look: Look,
    private readonly fonts: PdfFonts,
  ) {}

  private lines(style: LineStyle, walks: readonly Point[][], closed: boolean): void {
    if (walks.length === 0) return;
    this.page.pushOperators(
      pushGraphicsState(),
      setStrokingColor(colour(style.colour)),
      setLineWidth(points(style.width)),
      setLineJoin(1),
      setLineCap(style.dash.length > 0 ? 0 : 1),
      setDashPattern(style.dash.map(points), 0),
      ...walks.flatMap((walk) => [...path(walk, closed), stroke()]),
      popGraphicsState(),
    );
  }

  private areas(hex: string, walks: readonly Point[][]): void {
    if (hex === 'none' || walks.length === 0) return;
    this.page.pushOperators(
      pushGraphicsState(),
      setFillingColor(colour(hex)),
      ...walks.flatMap((walk) => [...path(walk, true), fill()]),
      popGraphicsState(),
    );
  }

  /** Runs of letters from each font in turn, and boxes for those that none has. */
  private text({ text, at, anchor, angle, size }: TextLine): void {
    const [cosine, sine] = directionOf(angle);
    const runs = this.fonts.runs(text);
    const width = runs.reduce((sum, run) => sum + this.fonts.width(run), 0);
    let along = anchor === 'middle' ? -width / 2 : 0;
    const on = (x: number, y: number): Point => [
      at[0] + size * (x * cosine - y * sine),
      at[1] + size * (x * sine + y * cosine),
    ];
    for (const run of runs) {
      if (run.slice < 0) {
        this.missing((x, y) => on(along + x, y), size);
        along += missingWidth;
        continue;
      }
      const [x, y] = on(along, 0);
      this.page.pushOperators(
        beginText(),
        setFillingColor(colour(this.look.text)),
        setFontAndSize(this.fonts.key(this.page, run.slice), points(size)),
        setTextMatrix(cosine, sine, -sine, cosine, points(x), points(y)),
        showText(this.fonts.font(run.slice).encodeText(run.letters)),
        endText(),
      );
      along += this.fonts.width(run);
    }
  }

  private missing(on: (x: number, y: number) => Point, size: number): void {
    const [left, bottom, right, top] = missingBox;
    const half = missingLine / 2;
    const walk = [
      on(left + half, bottom + half),
      on(right - half, bottom + half),
      on(right - half, top - half),
      on(left + half, top - half),
    ];
    this.lines({ width: missingLine * size, colour: this.look.text, dash: [] }, [walk], true);
  }

  private piece(piece: PieceDrawing): void {
    const { cut, mountain, valley } = this.look.lines;
    this.areas(this.look.flaps, piece.flaps);
    this.lines(mountain, piece.mountains, false);
    this.lines(valley, piece.valleys, false);
    for (const text of piece.texts) this.text(text);
    this.lines(cut, piece.cuts, true);
  }

  /** What belongs together is marked with a name, as the SVG's groups and pieces are. */
  private marked(name: string, draw: () => void): void {
    this.page.pushOperators(beginMarkedContent(name));
    draw();
    this.page.pushOperators(endMarkedContent());
  }

  private picture(shape: PictureShape): void {
    for (let first = 0; first < shape.walks.length; first += mostWalks) {
      this.part({ ...shape, walks: shape.walks.slice(first, first + mostWalks) });
    }
  }

  private part(shape: PictureShape): void {
    const { kind, walks } = shape;
    if (kind === 'line') {
      this.lines(shape.style, walks, shape.closed);
      return;
    }
    const edge = edgeStyle(shape.colour);
    this.page.pushOperators(
      pushGraphicsState(),
      setFillingColor(colour(shape.colour)),
      setStrokingColor(colour(shape.colour)),
      setLineWidth(points(edge.width)),
      setLineJoin(1),
      // In one go, or thin white lines would show between neighbours.
      ...walks.flatMap((walk) => path(walk, true)),
      fillAndStroke(),
      popGraphicsState(),
    );
  }

  write({ pieces, frame, picture = [] }: SheetDrawing): void {
    if (picture.length > 0) {
      this.marked('picture', () => {
        for (const shape of picture) this.picture(shape);
      });
    }
    this.marked('guide', () => {
      for (const { points: walk, closed, sample } of frame.strokes) {
        if (sample === 'flap') this.areas(this.look.flaps, [walk]);
        else this.lines(sample ? this.look.lines[sample] : guideStyle(this.look), [walk], closed);
      }
      for (const text of frame.texts) this.text(text);
    });
    for (const piece of pieces) {
      this.marked(`guide-${piece.letter}`, () => {
        this.lines(leaderStyle(this.look), piece.guides, false);
      });
      this.marked(`piece-${piece.letter}`, () => this.piece(piece));
    }
  }
}

/**
 * All sheets as one vector PDF at true size, a page for each, with scaling switched off in the print
 * dialogue, and of each font the letters that are used; before them the pages that tell how to build the
 * model, if they were asked for. The same print gives the same bytes.
 */
export async function writePdf(print: Print): Promise<Uint8Array> {
  const { title, look, loadFont } = print;
  const sheets = [...print.pages, ...print.sheets];
  const document = await PDFDocument.create({ updateMetadata: false });
  const set = print.fonts ?? (await FontSet.load(textsOf(sheets), loadFont));
  const fonts = await PdfFonts.embed(document, set);
  document.setTitle(title, { showInWindowTitleBar: true });
  document.setCreator('Foldwright');
  document.catalog.getOrCreateViewerPreferences().setPrintScaling(PrintScaling.None);
  for (const sheet of sheets) {
    const page = document.addPage([points(sheet.width), points(sheet.height)]);
    new PageWriter(page, look, fonts).write(sheet);
  }
  return document.save();
}
