/** Reads back what a PDF draws, page by page, with pdf.js; nothing here comes from the exporter. */
import { getDocument, OPS, type PDFPageProxy } from 'pdfjs-dist/legacy/build/pdf.mjs';
import {
  stripId,
  type GuideLines,
  type PieceLines,
  type Point,
  type SheetFile,
  type SheetText,
} from './sheet-file.js';

/** A path as it is painted, in mm from the lower left. */
export interface PdfPath {
  paint: 'stroke' | 'fill';
  /** Of a stroke; mm. */
  width: number;
  dash: number[];
  colour: string;
  closed: boolean;
  points: Point[];
}

/** A picture as it is painted. */
export interface PdfImage {
  layer: string;
  /** mm from the lower left. */
  left: number;
  bottom: number;
  right: number;
  top: number;
  width: number;
  height: number;
  /** 4 per dot, rows from above. */
  rgba: Uint8Array;
}

export interface PdfPage {
  sheet: SheetFile;
  images: PdfImage[];
  /** Everything on the page, in the order in which it is painted. */
  paths: PdfPath[];
  texts: SheetText[];
  /** Names of the layers that anything is in. */
  layers: Set<string>;
}

export interface PdfFile {
  pages: PdfPage[];
  /** Names of the layers, in the order in which readers list them. */
  layers: string[];
  /** What the print dialogue is told. */
  scaling: unknown;
  title: unknown;
}

const millimetres = 25.4 / 72;

/** What pdf.js encodes in a path, besides the curves that do not occur here. */
const pathStep = { moveTo: 0, lineTo: 1, close: 4 };

function walksOf(data: ArrayLike<number>): { points: Point[]; closed: boolean }[] {
  const walks: { points: Point[]; closed: boolean }[] = [];
  for (let i = 0; i < data.length;) {
    const step = data[i];
    if (step === pathStep.close) {
      walks.at(-1)!.closed = true;
      i += 1;
      continue;
    }
    const point: Point = [data[i + 1]! * millimetres, data[i + 2]! * millimetres];
    if (step === pathStep.moveTo) walks.push({ points: [point], closed: false });
    else if (step === pathStep.lineTo) walks.at(-1)!.points.push(point);
    else throw new Error(`a path has a step ${step}`);
    i += 3;
  }
  return walks;
}

type Transform = [number, number, number, number, number, number];

interface Glyph {
  unicode: string;
  /** In thousandths of the size of the font. */
  width: number;
}

/** The content of a page as it is told operator by operator. */
class PageReader {
  readonly paths: { path: PdfPath; mark: string; layer: string }[] = [];
  readonly texts: { text: SheetText; mark: string; layer: string }[] = [];
  readonly images: (Omit<PdfImage, 'rgba'> & { id: string })[] = [];
  /** Where the unit square lies, if it is moved. */
  private moved: Transform | null = null;
  private line = { width: 0, dash: [] as number[] };
  private colours = { stroke: '', fill: '' };
  private saved: (typeof this.line)[] = [];
  /** What encloses the present place: names, and layers. */
  private marks: { mark?: string; layer?: string }[] = [];
  private size = 0;
  private matrix: number[] = [];

  /** @param nameOf the name of a layer */
  constructor(private readonly nameOf: (id: string) => string) {}

  private get place(): { mark: string; layer: string } {
    const inner = [...this.marks].reverse();
    const mark = inner.find((mark) => mark.mark !== undefined)?.mark ?? '';
    return { mark, layer: inner.find(({ layer }) => layer !== undefined)?.layer ?? '' };
  }

  read(operator: number, values: unknown[]): void {
    switch (operator) {
      case OPS.save:
        this.saved.push(this.line);
        break;
      case OPS.restore:
        this.line = this.saved.pop()!;
        this.moved = null;
        break;
      case OPS.transform:
        this.moved = Array.from(values as number[]) as Transform;
        break;
      case OPS.paintImageXObject:
        this.image(values as [string, number, number]);
        break;
      case OPS.setLineWidth:
        this.line = { ...this.line, width: Number(values[0]) * millimetres };
        break;
      case OPS.setDash:
        this.line = {
          ...this.line,
          dash: (values[0] as number[]).map((length) => length * millimetres),
        };
        break;
      case OPS.setStrokeRGBColor:
        this.colours.stroke = String(values[0]);
        break;
      case OPS.setFillRGBColor:
        this.colours.fill = String(values[0]);
        break;
      case OPS.constructPath:
        this.path(values[0] as number, (values[1] as [ArrayLike<number>])[0]);
        break;
      case OPS.beginMarkedContent:
        this.marks.push({ mark: (values[0] as { name: string }).name });
        break;
      case OPS.beginMarkedContentProps:
        this.marks.push({ layer: this.nameOf((values[1] as { id: string }).id) });
        break;
      case OPS.endMarkedContent:
        this.marks.pop();
        break;
      case OPS.setFont:
        this.size = Number(values[1]) * millimetres;
        break;
      case OPS.setTextMatrix:
        this.matrix = Array.from(values[0] as number[]);
        break;
      case OPS.showText:
        this.text(values[0] as (Glyph | number)[]);
        break;
      default:
    }
  }

  private image([id, width, height]: [string, number, number]): void {
    if (!this.moved) throw new Error('an image has no place');
    const [a, b, c, d, e, f] = this.moved;
    if (b !== 0 || c !== 0) throw new Error('an image is turned');
    const [left, bottom, right, top] = [e, f, e + a, f + d].map((at) => at * millimetres) as [
      number,
      number,
      number,
      number,
    ];
    this.images.push({ id, layer: this.place.layer, left, bottom, right, top, width, height });
  }

  private path(painter: number, data: ArrayLike<number>): void {
    if (this.moved) throw new Error('a path is moved, turned or scaled');
    const paint = painter === OPS.fill ? 'fill' : 'stroke';
    for (const walk of walksOf(data)) {
      this.paths.push({
        path: { ...walk, ...this.line, paint, colour: this.colours[paint] },
        ...this.place,
      });
    }
  }

  private text(glyphs: (Glyph | number)[]): void {
    if (this.moved) throw new Error('a text is moved, turned or scaled');
    const letters = glyphs.filter((glyph) => typeof glyph !== 'number');
    const [cosine, sine, , , x, y] = this.matrix.map(Number);
    const width = (this.size * letters.reduce((sum, glyph) => sum + glyph.width, 0)) / 1000;
    const text: SheetText = {
      text: letters.map(({ unicode }) => unicode).join(''),
      at: [x! * millimetres + (cosine! * width) / 2, y! * millimetres + (sine! * width) / 2],
      angle: (Math.atan2(sine!, cosine!) * 180) / Math.PI,
      size: this.size,
      width,
    };
    this.texts.push({ text, ...this.place });
  }
}

function pieceOf(reader: PageReader, name: string): PieceLines {
  const mark = `piece-${name}`;
  const guides = reader.paths.filter((line) => line.mark === `guide-${name}`);
  const piece: PieceLines = {
    cuts: [],
    mountains: [],
    valleys: [],
    guides: guides.map(({ path }): [Point, Point] => [path.points[0]!, path.points[1]!]),
    texts: reader.texts.filter((line) => line.mark === mark).map(({ text }) => text),
    underlines: [],
  };
  for (const { path, layer } of reader.paths.filter((line) => line.mark === mark)) {
    const { closed, points } = path;
    const kind = ({ 'Mountain folds': 'mountains', 'Valley folds': 'valleys' } as const)[layer];
    if (kind) piece[kind].push([points[0]!, points[1]!]);
    // Boxes for letters that no font has are closed.
    if (layer === 'Numbers' && !closed) piece.underlines.push([points[0]!, points[1]!]);
    if (layer !== 'Cuts') continue;
    if (!closed) throw new Error('a cut is not closed');
    piece.cuts.push(points);
  }
  return piece;
}

/** Waits for a picture to be decoded. */
async function pixelsOf(page: PDFPageProxy, id: string): Promise<Uint8Array> {
  const { width, height, data } = await new Promise<{
    width: number;
    height: number;
    data: Uint8Array;
  }>((resolve) => {
    page.objs.get(id, resolve);
  });
  if (data.length !== 4 * width * height) throw new Error('an image has no transparency');
  return new Uint8Array(data);
}

async function readPage(page: PDFPageProxy, nameOf: (id: string) => string): Promise<PdfPage> {
  const { fnArray, argsArray } = await page.getOperatorList();
  const reader = new PageReader(nameOf);
  fnArray.forEach((operator, i) => reader.read(operator, (argsArray[i] ?? []) as unknown[]));
  const marks = new Set(reader.paths.map(({ mark }) => mark));
  const pieces = new Map<string, PieceLines>();
  const strips = new Map<string, PieceLines>();
  for (const mark of marks) {
    const name = /^piece-(.*)$/.exec(mark)?.[1];
    if (name === undefined) continue;
    const strip = stripId(name);
    if (strip === null) pieces.set(name, pieceOf(reader, name));
    else strips.set(strip, pieceOf(reader, name));
  }
  const ofGuide = <Item extends { mark: string }>(items: Item[]): Item[] =>
    items.filter(({ mark }) => mark === 'guide');
  const guide: GuideLines = {
    strokes: ofGuide(reader.paths).map(({ path }) => path.points),
    texts: ofGuide(reader.texts).map(({ text }) => text),
  };
  const images: PdfImage[] = [];
  for (const { id, ...image } of reader.images) {
    images.push({ ...image, rgba: await pixelsOf(page, id) });
  }
  const [, , width, height] = page.view;
  return {
    sheet: {
      width: width! * millimetres,
      height: height! * millimetres,
      pieces,
      strips,
      guide,
    },
    images,
    paths: reader.paths.map(({ path }) => path),
    texts: reader.texts.map(({ text }) => text),
    layers: new Set([...reader.images, ...reader.paths, ...reader.texts].map(({ layer }) => layer)),
  };
}

/** @throws if anything but straight lines and images is drawn, or lines are moved after they were drawn */
export async function readPdf(bytes: Uint8Array): Promise<PdfFile> {
  const task = getDocument({ data: bytes.slice(), useSystemFonts: false, verbosity: 0 });
  const document = await task.promise;
  const preferences: { PrintScaling?: unknown } | null = await document.getViewerPreferences();
  const { info } = await document.getMetadata();
  const content = await document.getOptionalContentConfig();
  const nameOf = (id: string): string => (content.getGroup(id) as { name: string }).name;
  const pages: PdfPage[] = [];
  for (let number = 1; number <= document.numPages; ++number) {
    pages.push(await readPage(await document.getPage(number), nameOf));
  }
  await task.destroy();
  return {
    pages,
    layers: (content.getOrder() as string[] | null)?.map(nameOf) ?? [],
    scaling: preferences?.PrintScaling,
    title: (info as { Title?: unknown }).Title,
  };
}
