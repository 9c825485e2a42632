import type { Piece, Sheet } from '../model/job.js';
import type { Context2d } from './context-2d.js';
import { boxAround } from './flat-net.js';
import { namePlace, writeName } from './net-name.js';
import { finishedNet } from './finished-net.js';
import { paintNet } from './net-picture.js';
import { rowsInView } from './rows-in-view.js';

/** A piece where it lies on its sheet; mm, y up, from the sheet's lower left. */
interface DraftPiece {
  name: string;
  part: number;
  sheet: number;
  /** 2 per corner, 3 corners per face. */
  corners: Float32Array;
  /** 8 per flap: foot, top, top, foot. */
  flaps: Float32Array;
}

/** Sheets that could be printed. */
export interface PaintedDraft {
  sheets: readonly Sheet[];
  pieces: readonly DraftPiece[];
  hatched: boolean;
}

/** Between two sheets, as a share of their width. */
const gapShare = 0.06;

/** CSS pixels across the least piece that has its name. */
const leastNamed = 26;

const [paper, edge, flapFill, flapLine] = ['#fffefb', 'rgb(35 42 49 / 35%)', '#e4e4e4', '#8a9096'];

/** What there is to paint of a piece. */
export function draftPiece(piece: Piece): DraftPiece {
  const { flaps, name, part, sheet, x, y } = piece;
  const moved = (values: ArrayLike<number>): Float32Array =>
    Float32Array.from(values, (value, i) => value + (i % 2 === 0 ? x : y));
  const corners = moved(finishedNet(piece).corners);
  return { name, part, sheet, corners, flaps: moved(flaps.corners) };
}

function paintFlaps(context: Context2d, flaps: Float32Array, scale: number): void {
  const path = new Path2D();
  for (let flap = 0; flap < flaps.length; flap += 8) {
    path.moveTo(scale * flaps[flap]!, -scale * flaps[flap + 1]!);
    for (let at = flap + 2; at < flap + 8; at += 2) {
      path.lineTo(scale * flaps[at]!, -scale * flaps[at + 1]!);
    }
  }
  [context.fillStyle, context.strokeStyle, context.lineWidth] = [flapFill, flapLine, 0.5];
  context.fill(path);
  context.stroke(path);
}

function paintPiece(context: Context2d, piece: DraftPiece, scale: number, hatched: boolean): void {
  const { corners, flaps, name, part } = piece;
  const faces = corners.length / 6;
  paintFlaps(context, flaps, scale);
  const parts = new Int32Array(faces).fill(part);
  const net = { corners, sources: parts, overlapping: new Uint8Array(faces) };
  paintNet(context, { net, parts, hatched }, { scale, x: 0, y: 0 });
  const { width, height } = boxAround(corners);
  if (scale * Math.min(width, height) < leastNamed) return;
  const { x, y } = namePlace(corners);
  writeName(context, name, scale * x, -scale * y);
}

/** Draws sheets with what is on them into a canvas of this size, in rows. */
export function drawDraft(
  context: Context2d,
  width: number,
  height: number,
  { sheets, pieces, hatched }: PaintedDraft,
): void {
  if (sheets.length === 0) return;
  const { spots, scale } = rowsInView(sheets, width, height, gapShare * sheets[0]!.width);
  sheets.forEach((sheet, i) => {
    const { x, y } = spots[i]!;
    context.save();
    context.translate(width / 2 + scale * x, height / 2 - scale * y);
    [context.fillStyle, context.strokeStyle, context.lineWidth] = [paper, edge, 1];
    context.fillRect(0, -scale * sheet.height, scale * sheet.width, scale * sheet.height);
    context.strokeRect(0, -scale * sheet.height, scale * sheet.width, scale * sheet.height);
    for (const piece of pieces) if (piece.sheet === i) paintPiece(context, piece, scale, hatched);
    context.restore();
  });
}
