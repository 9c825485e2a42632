import {
  beginMarkedContent,
  beginText,
  concatTransformationMatrix,
  drawObject,
  Duplex,
  endMarkedContent,
  endText,
  PDFDocument,
  PDFName,
  popGraphicsState,
  PDFOperator,
  PDFOperatorNames,
  PrintScaling,
  pushGraphicsState,
  setFillingColor,
  setFontAndSize,
  setTextMatrix,
  showText,
  type PDFPage,
} from 'pdf-lib';
import type { FontSet } from './font-set.js';
import { isPictured, type GroundShape } from './ground-shape.js';
import type { Layer } from './layers.js';
import { guideStyle, leaderStyle, penStyle, type Look } from './line-style.js';
import { outlinesOf, walksOf } from './outlines.js';
import { missingBox, missingLine, missingWidth } from './missing-sign.js';
import { inPairs } from './back-page.js';
import { PdfFonts } from './pdf-fonts.js';
import { PdfImages } from './pdf-images.js';
import { PdfLayers } from './pdf-layers.js';
import { colour, paintAreas, paintLines, paintShape, points } from './pdf-paint.js';
import type { Point } from './point.js';
import { fontsOf, type Print } from './print.js';
import { rimColour, textRimWidth } from './rims.js';
import type { PieceDrawing, RegistrationMarks, SheetDrawing } from './sheet-drawing.js';
import { directionOf, underlineOf, type TextLine } from './text-line.js';

const black = '#000000';

/** What all pages of a document share. */
interface PageParts {
  look: Look;
  /** Of texts as text, or of those whose outlines a pen draws. */
  fonts: PdfFonts | FontSet;
  layers: PdfLayers;
  images: PdfImages;
}

/** Writes one sheet on its page. */
class PageWriter {
  private readonly operators: PDFOperator[] = [];
  private readonly look: Look;
  private readonly fonts: PageParts['fonts'];
  private readonly layers: PdfLayers;
  private readonly images: PdfImages;

  constructor(
    private readonly page: PDFPage,
    { look, fonts, layers, images }: PageParts,
  ) {
    this.look = look;
    this.fonts = fonts;
    this.layers = layers;
    this.images = images;
  }

  /** One by one: a large sheet has more than a call takes arguments. */
  private add(operators: readonly PDFOperator[]): void {
    for (const operator of operators) this.operators.push(operator);
  }

  private lines(...what: Parameters<typeof paintLines>): void {
    this.add(paintLines(...what));
  }

  private areas(hex: string, walks: readonly Point[][]): void {
    this.add(paintAreas(hex, walks));
  }

  private text(line: TextLine): void {
    const { fonts } = this;
    const isPrinted = fonts instanceof PdfFonts;
    if (isPrinted) this.printed(line, fonts);
    else this.lines(penStyle(this.look), walksOf(outlinesOf(line, fonts)), true);
    if (!line.underlined) return;
    const { line: segment, width } = underlineOf(line);
    const style = isPrinted ? { width, colour: this.look.text, dash: [] } : penStyle(this.look);
    this.lines(style, [segment], false);
  }

  /** Runs of letters from each font in turn, and boxes for those that none has. */
  private printed({ text, at, anchor, angle, size }: TextLine, fonts: PdfFonts): void {
    const [cosine, sine] = directionOf(angle);
    const runs = fonts.runs(text);
    const width = runs.reduce((sum, run) => sum + fonts.width(run), 0);
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
      this.add([
        beginText(),
        setFillingColor(colour(this.look.text)),
        setFontAndSize(fonts.key(this.page, run.slice), points(size)),
        setTextMatrix(cosine, sine, -sine, cosine, points(x), points(y)),
        showText(fonts.font(run.slice).encodeText(run.letters)),
        endText(),
      ]);
      along += fonts.width(run);
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
    this.layer('flap', () => this.areas(this.look.flaps, piece.flaps));
    this.layer('fold-mountain', () => this.lines(mountain, piece.mountains, false));
    this.layer('fold-valley', () => this.lines(valley, piece.valleys, false));
    this.layer('id', () => {
      for (const text of piece.texts) {
        if (isPictured(piece)) this.textRim(text);
        this.text(text);
      }
    });
    this.layer('cut', () => this.lines(cut, piece.cuts, true));
  }

  /** Nothing around the letters that a pen draws. */
  private textRim(line: TextLine): void {
    if (!(this.fonts instanceof PdfFonts)) return;
    const style = { width: textRimWidth, colour: rimColour, dash: [] };
    // So wide a line hides that curves are straight.
    this.lines(style, walksOf(outlinesOf(line, this.fonts.set), 1), true);
  }

  private ground(shape: GroundShape): void {
    if (shape.kind !== 'image') {
      this.add(paintShape(shape));
      return;
    }
    const [[left, bottom], [right, top]] = shape.corners.map((corner) => corner.map(points)) as [
      Point,
      Point,
    ];
    this.add([
      pushGraphicsState(),
      concatTransformationMatrix(right - left, 0, 0, top - bottom, left, bottom),
      drawObject(this.images.key(this.page, shape.image)),
      popGraphicsState(),
    ]);
  }

  /** Encloses what is drawn, if anything is. */
  private enclosed(begin: () => PDFOperator, draw: () => void): void {
    const start = this.operators.length;
    draw();
    if (this.operators.length === start) return;
    this.operators.splice(start, 0, begin());
    this.operators.push(endMarkedContent());
  }

  /** What belongs together is marked with a name, as the SVG's pieces are. */
  private marked(name: string, draw: () => void): void {
    this.enclosed(() => beginMarkedContent(name), draw);
  }

  private layer(layer: Layer, draw: () => void): void {
    const begin = (): PDFOperator =>
      PDFOperator.of(PDFOperatorNames.BeginMarkedContentSequence, [
        PDFName.of('OC'),
        this.layers.key(this.page, layer),
      ]);
    this.enclosed(begin, draw);
  }

  private registration({ square, corners, width }: RegistrationMarks): void {
    this.areas(black, [square]);
    this.lines({ width, colour: black, dash: [] }, corners, false, true);
  }

  write({ pieces, frame, picture = [], registration }: SheetDrawing): void {
    for (const { letter, ground } of pieces) {
      this.marked(`ground-${letter}`, () =>
        this.layer('texture', () => {
          for (const shape of ground) this.ground(shape);
        }),
      );
    }
    this.marked('picture', () =>
      this.layer('guide', () => {
        for (const shape of picture) this.add(paintShape(shape));
      }),
    );
    if (registration) this.layer('registration', () => this.registration(registration));
    this.marked('guide', () =>
      this.layer('guide', () => {
        for (const { points: walk, closed, sample } of frame.strokes) {
          if (sample === 'flap') this.areas(this.look.flaps, [walk]);
          else this.lines(sample ? this.look.lines[sample] : guideStyle(this.look), [walk], closed);
        }
        for (const text of frame.texts) this.text(text);
      }),
    );
    for (const piece of pieces) {
      this.marked(`guide-${piece.letter}`, () =>
        this.layer('guide', () => this.lines(leaderStyle(this.look), piece.guides, false)),
      );
      this.marked(`piece-${piece.letter}`, () => this.piece(piece));
    }
    for (const operator of this.operators) this.page.pushOperators(operator);
  }
}

/**
 * Sheets as one vector PDF at true size, a page for each, with scaling switched off in the print
 * dialogue, and of each font the letters that are used; by default all sheets, and before them the pages
 * that tell how to build the model, and behind each its back, if they were asked for. What the SVG has as groups are layers. The
 * same print gives the same bytes.
 */
export async function writePdf(
  print: Print,
  sheets: readonly SheetDrawing[] = inPairs(print.pages, print.sheets, print.backs),
): Promise<Uint8Array> {
  const { title, look, machine } = print;
  const document = await PDFDocument.create({ updateMetadata: false });
  const set = await fontsOf(print);
  const fonts = machine === 'none' ? await PdfFonts.embed(document, set) : set;
  const layers = new PdfLayers(document);
  const parts = { look, fonts, layers, images: new PdfImages(document) };
  document.setTitle(title, { showInWindowTitleBar: true });
  document.setCreator('Foldwright');
  const preferences = document.catalog.getOrCreateViewerPreferences();
  preferences.setPrintScaling(PrintScaling.None);
  if (print.backs.length > 0) preferences.setDuplex(Duplex.DuplexFlipLongEdge);
  for (const sheet of sheets) {
    const page = document.addPage([points(sheet.width), points(sheet.height)]);
    new PageWriter(page, parts).write(sheet);
  }
  layers.list();
  return document.save();
}
