import type { JobResult, Notice } from '../model/job.js';
import { isCalibrated, type Machine, type PrintOptions } from '../model/print-options.js';
import { calibrated, corrections, overrun } from './calibration.js';
import type { FontLoader } from './font-loader.js';
import type { FontSet } from './font-set.js';
import type { RendererLoader } from './renderer-loader.js';
import { frameSheet } from './sheet-frame.js';
import { placeLegend } from './legend.js';
import { lookOf, type Look } from './line-style.js';
import { forMachine, machineNotices } from './machine.js';
import { drawPieces, type SheetDrawing } from './sheet-drawing.js';
import { cleaned } from './text-line.js';

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

/** All sheets of a job, ready to be written in any format. */
export interface Print {
  title: string;
  look: Look;
  machine: Machine;
  /** Pixels to the inch of pictures. */
  dpi: number;
  sheets: SheetDrawing[];
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

function noteOf(sheet: number, count: number, options: PrintOptions): string {
  const page = `sheet ${sheet + 1} of ${count} · print at 100 %`;
  if (!isCalibrated(options)) return page;
  return `${page} · corrected for ${options.measured.join(' × ')} mm`;
}

function noticesOf(sheets: readonly SheetDrawing[], lacksLegend: boolean): Notice[] {
  const notices: Notice[] = [];
  if (lacksLegend) notices.push({ code: 'no-legend', params: {} });
  const beyond = Math.max(...sheets.map(overrun));
  if (beyond > 0) notices.push({ code: 'beyond-page', params: { by_mm: beyond } });
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

/** The sheets as they shall be on paper, and whether a legend that was asked for is on one of them. */
function drawSheets({ result, title, margin, options }: PrintInput): {
  sheets: SheetDrawing[];
  lacksLegend: boolean;
} {
  const count = result.sheets.length;
  const sheets = result.sheets.map(({ width, height }, sheet): SheetDrawing => {
    const note = noteOf(sheet, count, options);
    return {
      width,
      height,
      pieces: drawPieces(result, sheet, options),
      frame: frameSheet({ width, height, margin, title: cleaned(title), note }),
    };
  });
  if (!options.legend || options.machine !== 'none') return { sheets, lacksLegend: false };
  const found = placeLegend(sheets, margin);
  if (!found) return { sheets, lacksLegend: true };
  const { strokes, texts } = sheets[found.sheet]!.frame;
  sheets[found.sheet]!.frame = {
    strokes: [...strokes, ...found.legend.strokes],
    texts: [...texts, ...found.legend.texts],
  };
  return { sheets, lacksLegend: false };
}

const pageLookOf = (options: PrintOptions): Look => lookOf({ ...options, machine: 'none' });

/** The pages that tell how to build the model. No printer's scale is corrected: nothing is measured there. */
async function drawPages({ margin, options, result, title }: PrintInput): Promise<SheetDrawing[]> {
  if (!options.assembly) return [];
  const { assemblyPages } = await import('./assembly-pages.js');
  return assemblyPages({
    margin,
    options,
    result,
    title: cleaned(title),
    look: pageLookOf(options),
  });
}

/**
 * Draws all sheets. Fonts are loaded only for letters that not every reader has, and for machines;
 * whatever no font has is drawn as a box and told in the notices, and so is it when fonts do not come.
 */
export async function preparePrint(input: PrintInput): Promise<Print> {
  const { options, loadFont, loadRenderer } = input;
  const { machine, dpi } = options;
  const { sheets: drawn, lacksLegend } = drawSheets(input);
  const factors = corrections(options);
  const sheets = drawn.map((sheet) =>
    machine === 'none' ? calibrated(sheet, factors) : forMachine(sheet, machine),
  );
  const notices = [...noticesOf(sheets, lacksLegend), ...machineNotices(sheets, machine)];
  const pages = await drawPages(input);
  const texts = textsOf([...pages, ...sheets]);
  const isText = machine === 'none' && texts.every(isPlain);
  const fonts = isText ? null : await loadFonts(texts, loadFont, notices);
  return {
    title: cleaned(input.title),
    look: lookOf(options),
    machine,
    dpi,
    sheets,
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
  return { ...print, look: print.pageLook, machine: 'none', sheets: print.pages, pages: [] };
}

/** All fonts that the texts need, for formats that have none of their own. */
export async function fontsOf({ fonts, pages, sheets, loadFont }: Print): Promise<FontSet> {
  if (fonts) return fonts;
  const { FontSet } = await import('./font-set.js');
  return FontSet.load(textsOf([...pages, ...sheets]), loadFont);
}
