import type { JobResult, Notice, Piece } from '../../model/job.js';
import { originalOf, type Looks } from '../../model/looks.js';
import { partRgb } from '../../model/part-colours.js';
import { printsPartColours, type PrintOptions } from '../../model/print-options.js';
import type { RendererLoader } from '../renderer-loader.js';
import type { Grid } from './cover.js';
import { loadPictures, type LoadedPictures } from './load-pictures.js';
import { PiecePainter, type PaintedPiece } from './paint-piece.js';
import { pngFile } from './png-file.js';

/** A piece in the model's colours; it is painted when it is first asked for. */
export class PieceImage {
  private file: Uint8Array | null = null;

  constructor(
    readonly grid: Grid,
    /** Paints it anew: 4 values per dot. */
    readonly paint: () => PaintedPiece,
  ) {}

  /** Kept, as whatever is written is often written again. */
  png(): Uint8Array {
    if (this.file) return this.file;
    const { rgba, width, height } = this.paint();
    return (this.file = pngFile({ width, height, values: rgba, channels: 4 }));
  }
}

export interface PieceImages {
  images: ReadonlyMap<Piece, PieceImage>;
  notices: Notice[];
}

/** What is printed on the pieces of a result. */
export interface ImageWish {
  /** None where faces have the colours of their parts, or those of paper. */
  looks: Looks | null;
  isShaded: boolean;
  options: PrintOptions;
}

const white = [255, 255, 255] as const;

async function makeImages(
  result: JobResult,
  { looks, isShaded, options }: ImageWish,
  loadRenderer: RendererLoader,
): Promise<PieceImages> {
  const { dpi, flapBleed } = options;
  const none: LoadedPictures = { pictures: [], notices: [] };
  const { pictures, notices } = looks ? await loadPictures(looks, loadRenderer) : none;
  const { model } = result;
  const original = originalOf(result);
  const colourOf = ({ part }: Piece): readonly number[] =>
    printsPartColours(options) ? partRgb(part) : white;
  const plan = { model, original, looks, pictures, isShaded, colourOf, dpi, flapBleed };
  const painter = new PiecePainter(plan);
  const images = result.pieces.map((piece): [Piece, PieceImage] => {
    const { height } = result.sheets[piece.sheet]!;
    const grid = painter.gridOf(piece, height);
    return [piece, new PieceImage(grid, () => painter.paint(piece, grid))];
  });
  return { images: new Map(images), notices };
}

/** Those of each result as they were asked for last: other changes of a print leave them as they are. */
const known = new WeakMap<JobResult, { key: string; made: Promise<PieceImages> }>();

const isPassing = ({ code }: Notice): boolean => code === 'pictures-not-loaded';

/** The pieces of a result in the colours of the model, or in its light, or both. */
export function pieceImages(
  result: JobResult,
  wish: ImageWish,
  loadRenderer: RendererLoader,
): Promise<PieceImages> {
  const { dpi, flapBleed, colour, machine } = wish.options;
  const key = JSON.stringify([!wish.looks, wish.isShaded, dpi, flapBleed, colour, machine]);
  const before = known.get(result);
  if (before?.key === key) return before.made;
  const made = makeImages(result, wish, loadRenderer);
  known.set(result, { key, made });
  // Another try may succeed.
  const forget = (): boolean => known.delete(result);
  made.then(({ notices }) => notices.some(isPassing) && forget()).catch(forget);
  return made;
}
