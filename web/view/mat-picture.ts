import type { Context2d } from './context-2d.js';
import type { FlatNet } from './flat-net.js';
import { paintNet } from './net-picture.js';
import { rowsInView } from './rows-in-view.js';

/** A net on the mat; `corners` are empty where its shape is not known. */
export interface MatNet extends FlatNet {
  part: number;
}

export interface PaintedMat {
  nets: readonly MatNet[];
  hatched: boolean;
  /** In which what is not known is drawn. */
  ink: string;
}

/** Between two nets, as a share of their mean length. */
const gapShare = 0.12;

/** Where a shape is not known there is a frame for it. */
function drawFrame(context: Context2d, ink: string, side: number): void {
  context.strokeStyle = ink;
  context.lineWidth = 1;
  context.setLineDash([4, 3]);
  context.strokeRect(0, -side, side, side);
  context.setLineDash([]);
}

function drawNetAt(context: Context2d, net: MatNet, scale: number, mat: PaintedMat): void {
  const { corners, part, width } = net;
  const faces = corners.length / 6;
  if (faces === 0) drawFrame(context, mat.ink, scale * width);
  else {
    const parts = new Int32Array(faces).fill(part);
    const picture = { corners, sources: parts, overlapping: new Uint8Array(faces) };
    paintNet(context, { net: picture, parts, hatched: mat.hatched }, { scale, x: 0, y: 0 });
  }
}

/**
 * Draws nets side by side into a canvas of this size, in rows, all at the same scale. They have no names: letters go by
 * the order of gluing, which is known when all are found.
 */
export function drawMat(context: Context2d, width: number, height: number, mat: PaintedMat): void {
  const { nets } = mat;
  if (nets.length === 0) return;
  const mean = nets.reduce((sum, net) => sum + net.width + net.height, 0) / (2 * nets.length);
  const { spots, scale } = rowsInView(nets, width, height, gapShare * mean);
  nets.forEach((net, i) => {
    const { x, y } = spots[i]!;
    context.save();
    context.translate(width / 2 + scale * x, height / 2 - scale * y);
    drawNetAt(context, net, scale, mat);
    context.restore();
  });
}
