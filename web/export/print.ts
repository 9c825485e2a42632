import type { JobResult, Notice, Piece } from '../model/job.js';
import { originalOf } from '../model/looks.js';
import {
  isCalibrated,
  printsBacks,
  printsShading,
  printsTexture,
  type Machine,
  type PrintOptions,
} from '../model/print-options.js';
import { alignmentCrosses, crossRoom } from './alignment-cross.js';
import { backOf } from './back-page.js';
import {
  calibrated,
  corrections,
  lostBorder,
  marginFor,
  overrun,
  type Printer,
} from './calibration.js';
import { withFoldTicks } from './fold-ticks.js';
import type { FontLoader } from './font-loader.js';
import type { FontSet } from './font-set.js';
import type { RendererLoader } from './renderer-loader.js';
import { frameSheet } from './sheet-frame.js';
import { placeLegend } from './legend.js';
import { lookOf, type Look } from './line-style.js';
import { forMachine, machineNotices } from './machine.js';
import { withRims } from './rims.js';
import type { PieceImage, PieceImages } from './texture/piece-images.js';
import { drawNamesBeside, drawPieces, type SheetDrawing } from './sheet-drawing.js';
import { cleaned } from './text-line.js';
import { loadWords } from '../words/load.js';
import type { Words } from '../words/words.js';

/** What sheets are made of. */
export interface PrintInput {
  result: JobResult;
  /** Printed on every sheet; usually the model's name. */
  title: string;
  /** Of the sheets, as the job had it; mm. */
  margin: number;
  options: PrintOptions;
  loadFont: FontLoader;
  loadRenderer: RendererLoader;
}

/** With the words of the language that is asked for. */
type Drawn = PrintInput & { words: Words };

/** All sheets of a job, ready to be written in any format. */
export interface Print {
  title: string;
  look: Look;
  machine: Machine;
  /** Pixels to the inch of pictures. */
  dpi: number;
  sheets: SheetDrawing[];
  /** One for each sheet if they are printed on both sides, else none. */
  backs: SheetDrawing[];
  /** Those that tell how to build the model, if they were asked for: the cover first. */
  pages: SheetDrawing[];
  /** Of those: they are for people, whoever cuts the sheets. */
  pageLook: Look;
  /** Null while all texts are in letters that every reader of files has, and are printed as text. */
  fonts: FontSet | null;
  loadFont: FontLoader;
  loadRenderer: RendererLoader;
  /** What a person should know of the sheets beside what the job told. */
  notices: Notice[];
}

/** Whether a text is in letters that every sans-serif face has. */
export function isPlain(text: string): boolean {
  return /^[\u0020-\u007e\u00a0-\u017f–—‘’“”…]*$/.test(text);
}

/** Every text that is printed. */
export function textsOf(sheets: readonly SheetDrawing[]): string[] {
  return sheets.flatMap(({ pieces, frame }) =>
    [...frame.texts, ...pieces.flatMap(({ texts }) => texts)].map(({ text }) => text),
  );
}

/** Whether the light of a result's surface is printed; not before the surface is there that it is taken from. */
function isShaded(result: JobResult, options: PrintOptions): boolean {
  return printsShading(options) && (result.deviation === 0 || originalOf(result) !== null);
}

/** The pieces in the model's colours and light; none if they are not printed so. */
async function drawImages({ options, result, loadRenderer }: PrintInput): Promise<PieceImages> {
  const takesLooks = printsTexture(options);
  const looks = (takesLooks && result.looks) || null;
  const wish = { looks, isShaded: isShaded(result, options), options };
  const notices: Notice[] =
    takesLooks && !looks && options.texture === 'on' ? [{ code: 'no-looks', params: {} }] : [];
  if (!looks && !wish.isShaded) return { images: new Map(), notices };
  const { pieceImages } = await import('./texture/piece-images.js');
  const made = await pieceImages(result, wish, loadRenderer);
  return { ...made, notices: [...notices, ...made.notices] };
}

function noteOf(sheet: number, count: number, { options, words }: Drawn): string {
  const page = words.sheets.note(sheet + 1, count);
  if (!isCalibrated(options)) return page;
  return `${page} · ${words.sheets.corrected(...options.measured)}`;
}

function noticesOf(
  sheets: readonly SheetDrawing[],
  lacksLegend: boolean,
  printer: Printer,
): Notice[] {
  const notices: Notice[] = [];
  if (lacksLegend) notices.push({ code: 'no-legend', params: {} });
  const beyond = Math.max(...sheets.map(overrun));
  if (beyond > 0) {
    const margin = Math.max(...sheets.map((sheet) => marginFor(sheet, printer)));
    notices.push({ code: 'beyond-page', params: { by_mm: beyond, margin_mm: margin } });
  }
  return notices;
}

/** The fonts of texts that become outlines; null if they did not come. */
async function loadFonts(
  texts: string[],
  loadFont: FontLoader,
  notices: Notice[],
): Promise<FontSet | null> {
  const { FontSet } = await import('./font-set.js');
  try {
    const fonts = await FontSet.load(texts, loadFont);
    if (fonts.missing.length > 0) {
      notices.push({ code: 'missing-glyphs', params: { letters: fonts.missing } });
    }
    return fonts;
  } catch {
    // Sheets without their proper letters are better than none.
    notices.push({ code: 'fonts-not-loaded', params: {} });
    return null;
  }
}

/** The sheets without their legend, their folds as lines. */
function drawFronts(input: Drawn, images: ReadonlyMap<Piece, PieceImage>): SheetDrawing[] {
  const { result, title, margin, options, words } = input;
  const count = result.sheets.length;
  const isTwoSided = printsBacks(options);
  return result.sheets.map(({ width, height }, sheet): SheetDrawing => {
    const note = noteOf(sheet, count, input);
    const ends = isTwoSided ? crossRoom : 0;
    const inset = lostBorder({ width, height }, options);
    const size = { width, height, margin, inset };
    const frame = frameSheet({ ...size, title: cleaned(title), note, ends, words });
    if (isTwoSided) frame.strokes.push(...alignmentCrosses(size, margin, inset));
    const names = drawNamesBeside(result, sheet);
    frame.strokes.push(...names.strokes);
    frame.texts.push(...names.texts);
    return { width, height, pieces: drawPieces(result, sheet, options, images), frame };
  });
}

function drawBacks(fronts: readonly SheetDrawing[], input: Drawn): SheetDrawing[] {
  const { margin, options, words } = input;
  if (!printsBacks(options)) return [];
  const [title, count] = [cleaned(input.title), fronts.length];
  return fronts.map((sheet, i) => {
    const inset = lostBorder(sheet, options);
    return backOf({ sheet, number: i + 1, count, margin, inset, title, words });
  });
}

/** Adds a legend, if it was asked for and one of the sheets has room; tells whether one is lacking. */
function addLegend(sheets: readonly SheetDrawing[], { margin, options, words }: Drawn): boolean {
  if (!options.legend || options.machine !== 'none') return false;
  const found = placeLegend(sheets, margin, options, words);
  if (!found) return true;
  const { strokes, texts } = sheets[found.sheet]!.frame;
  sheets[found.sheet]!.frame = {
    strokes: [...strokes, ...found.legend.strokes],
    texts: [...texts, ...found.legend.texts],
  };
  return false;
}

/** A sheet as it goes to whoever cuts it. */
function finished(sheet: SheetDrawing, options: PrintOptions): SheetDrawing {
  const { foldTicks, machine } = options;
  if (machine !== 'none') return forMachine(sheet, machine);
  const pieces = foldTicks ? sheet.pieces.map(withFoldTicks) : sheet.pieces;
  return withRims(calibrated({ ...sheet, pieces }, corrections(options)), lookOf(options));
}

const pageLookOf = (options: PrintOptions): Look => lookOf({ ...options, machine: 'none' });

/** The pages that tell how to build the model. No printer's scale is corrected: nothing is measured there. */
async function drawPages({
  margin,
  options,
  result,
  title,
  words,
}: Drawn): Promise<SheetDrawing[]> {
  if (!options.assembly) return [];
  const { assemblyPages } = await import('./assembly-pages.js');
  return assemblyPages({
    margin,
    options,
    result,
    title: cleaned(title),
    look: pageLookOf(options),
    words: words.building,
  });
}

/**
 * Draws all sheets. Fonts are loaded only for letters that not every reader has, and for machines;
 * whatever no font has is drawn as a box and told in the notices, and so is it when fonts do not come.
 */
export async function preparePrint(input: PrintInput): Promise<Print> {
  const { options, loadFont, loadRenderer } = input;
  const { machine, dpi } = options;
  const { images, notices: told } = await drawImages(input);
  const drawn = { ...input, words: await loadWords(options.language) };
  const fronts = drawFronts(drawn, images);
  const lacksLegend = addLegend(fronts, drawn);
  const sheets = fronts.map((sheet) => finished(sheet, options));
  const backs = drawBacks(fronts, drawn).map((back) => calibrated(back, corrections(options)));
  const notices = [
    ...told,
    ...noticesOf(sheets, lacksLegend, options),
    ...machineNotices(sheets, machine),
  ];
  const pages = await drawPages(drawn);
  const texts = textsOf([...pages, ...sheets, ...backs]);
  const isText = machine === 'none' && texts.every(isPlain);
  const fonts = isText ? null : await loadFonts(texts, loadFont, notices);
  return {
    title: cleaned(input.title),
    look: lookOf(options),
    machine,
    dpi,
    sheets,
    backs,
    pages,
    pageLook: pageLookOf(options),
    fonts,
    loadFont,
    loadRenderer,
    notices,
  };
}

/** The pages that tell how to build the model as sheets of their own. */
export function pagesOf(print: Print): Print {
  return {
    ...print,
    look: print.pageLook,
    machine: 'none',
    sheets: print.pages,
    backs: [],
    pages: [],
  };
}

/** All fonts that the texts need, for formats that have none of their own. */
export async function fontsOf(print: Print): Promise<FontSet> {
  const { backs, fonts, pages, sheets, loadFont } = print;
  if (fonts) return fonts;
  const { FontSet } = await import('./font-set.js');
  return FontSet.load(textsOf([...pages, ...sheets, ...backs]), loadFont);
}
