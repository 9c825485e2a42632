import {
  closePath,
  concatTransformationMatrix,
  lineTo,
  moveTo,
  PDFDocument,
  popGraphicsState,
  PrintScaling,
  pushGraphicsState,
  rgb,
  setDashPattern,
  setLineCap,
  setLineJoin,
  setLineWidth,
  setStrokingColor,
  StandardFonts,
  stroke,
  type PDFFont,
  type PDFOperator,
  type PDFPage,
} from 'pdf-lib';
import type { JobResult } from '../model/job.js';
import { baselineOf, directionOf, type Label } from './label.js';
import { lineStyles, textColour, type LineKind } from './line-style.js';
import type { Point } from './point.js';
import { drawSheet, type DrawingOptions } from './sheet-drawing.js';

export interface PdfOptions extends DrawingOptions {
  /** Named at the top of every page; usually the model's name. */
  title: string;
  /** Width of the margin that the pieces keep free, in mm; default 10. */
  margin?: number;
}

/** Points per millimetre. */
const scale = 72 / 25.4;
const rulerLength = 50;
// The text and the ruler with its figures need this much height.
const leastMargin = 5;
// 7 points: small, but readable on every printer.
const noteSize = 2.5;

function colour(hex: string): ReturnType<typeof rgb> {
  const channel = (at: number): number => Number.parseInt(hex.slice(at, at + 2), 16) / 255;
  return rgb(channel(1), channel(3), channel(5));
}

/** Lines of one kind as operators; `closed` joins the last point of each line to its first. */
function lines(kind: LineKind, walks: Point[][], closed: boolean): PDFOperator[] {
  const style = lineStyles[kind];
  const operators = [
    pushGraphicsState(),
    setStrokingColor(colour(style.colour)),
    setLineWidth(style.width * scale),
    setLineJoin(1),
    setLineCap(style.dash.length > 0 ? 0 : 1),
    setDashPattern(
      style.dash.map((length) => length * scale),
      0,
    ),
  ];
  for (const walk of walks) {
    walk.forEach(([x, y], i) => {
      operators.push((i === 0 ? moveTo : lineTo)(x * scale, y * scale));
    });
    if (closed) operators.push(closePath());
    operators.push(stroke());
  }
  return [...operators, popGraphicsState()];
}

/** The standard fonts know only the Latin alphabet; other letters become question marks. */
function encodable(text: string, font: PDFFont): string {
  const known = new Set(font.getCharacterSet());
  return [...text].map((letter) => (known.has(letter.codePointAt(0)!) ? letter : '?')).join('');
}

function drawLabel(page: PDFPage, font: PDFFont, label: Label): void {
  const [x, y] = baselineOf(label);
  const [cosine, sine] = directionOf(label);
  const size = label.size * scale;
  page.pushOperators(
    pushGraphicsState(),
    concatTransformationMatrix(cosine, sine, -sine, cosine, x * scale, y * scale),
  );
  page.drawText(label.text, {
    x: -font.widthOfTextAtSize(label.text, size) / 2,
    y: 0,
    size,
    font,
    color: colour(textColour),
  });
  page.pushOperators(popGraphicsState());
}

/** A ruler along the lower margin, to be laid beside a real one after printing. */
function drawRuler(page: PDFPage, font: PDFFont, left: number, top: number): void {
  const ticks = Array.from({ length: rulerLength / 10 + 1 }, (_, i): Point[] => {
    const x = left + 10 * i;
    return [
      [x, top],
      [x, top - 1.5],
    ];
  });
  const base: Point[] = [
    [left, top],
    [left + rulerLength, top],
  ];
  page.pushOperators(...lines('cut', [base, ...ticks], false));
  const options = { y: (top - 2) * scale, size: noteSize * scale, font, color: colour(textColour) };
  page.drawText('50 mm', { x: (left + rulerLength + 1.5) * scale, ...options });
}

/** Title above the pieces and ruler below them, each only where the margin has room for it. */
function drawNotes(page: PDFPage, font: PDFFont, note: string, margin: number): void {
  if (margin < leastMargin) return;
  const { width, height } = page.getSize();
  const size = noteSize * scale;
  const available = width - 2 * margin * scale;
  if (font.widthOfTextAtSize(note, size) <= available) {
    page.drawText(note, {
      x: margin * scale,
      y: height - (margin - 1.5) * scale,
      size,
      font,
      color: colour(textColour),
    });
  }
  // 12 mm: the figures beside the ruler.
  if (available >= (rulerLength + 12) * scale) drawRuler(page, font, margin, margin - 1.5);
}

/**
 * All sheets as one vector PDF at true size, a page for each, with scaling switched off in the
 * print dialogue. The same result gives the same bytes.
 */
export async function writePdf(result: JobResult, options: PdfOptions): Promise<Uint8Array> {
  const document = await PDFDocument.create({ updateMetadata: false });
  const font = await document.embedFont(StandardFonts.Helvetica);
  const title = encodable(options.title, font);
  document.setTitle(options.title);
  document.setCreator('Foldwright');
  document.catalog.getOrCreateViewerPreferences().setPrintScaling(PrintScaling.None);
  result.sheets.forEach((_, index) => {
    const sheet = drawSheet(result, index, options);
    const page = document.addPage([sheet.width * scale, sheet.height * scale]);
    for (const piece of sheet.pieces) {
      page.pushOperators(
        ...lines('guide', piece.guides, false),
        ...lines('mountain', piece.mountains, false),
        ...lines('valley', piece.valleys, false),
        ...lines('cut', piece.cuts, true),
      );
      for (const label of piece.labels) drawLabel(page, font, label);
    }
    const count = result.sheets.length;
    const note = `${title} - sheet ${index + 1} of ${count} - print at 100 %`;
    drawNotes(page, font, note, options.margin ?? 10);
  });
  return document.save();
}
