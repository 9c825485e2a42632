import type { JobResult, Notice, Piece } from '../../model/job.js';
import type { Looks } from '../../model/looks.js';
import type { PrintOptions } from '../../model/print-options.js';
import type { RendererLoader } from '../renderer-loader.js';
import type { Grid } from './cover.js';
import { loadPictures } from './load-pictures.js';
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

async function makeImages(
  result: JobResult,
  looks: Looks,
  { dpi, flapBleed }: PrintOptions,
  loadRenderer: RendererLoader,
): Promise<PieceImages> {
  const { pictures, notices } = await loadPictures(looks, loadRenderer);
  const painter = new PiecePainter({ model: result.model, looks, pictures, dpi, flapBleed });
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

/** The pieces of a result in the model's colours, of which it must have some. */
export function pieceImages(
  result: JobResult,
  looks: Looks,
  options: PrintOptions,
  loadRenderer: RendererLoader,
): Promise<PieceImages> {
  const key = JSON.stringify([options.dpi, options.flapBleed]);
  const before = known.get(result);
  if (before?.key === key) return before.made;
  const made = makeImages(result, looks, options, loadRenderer);
  known.set(result, { key, made });
  // Another try may succeed.
  const forget = (): boolean => known.delete(result);
  made.then(({ notices }) => notices.some(isPassing) && forget()).catch(forget);
  return made;
}
