import type { MatrixPicture } from '../model/job.js';
import type { PictureSize } from './picture-size.js';
import type { Canvas2d, Context2d } from './context-2d.js';
import { drawDraft, type PaintedDraft } from './draft-picture.js';
import type { CanvasMessage } from './drawing.js';
import { drawMat, type PaintedMat } from './mat-picture.js';
import { drawMatrix } from './matrix-picture.js';
import { drawNet, type PaintedNet } from './net-picture.js';
import { Redraw } from './redraw.js';

/** What there is to see on a flat picture, in plain data. */
export type PictureMessage =
  | ({ type: 'net' } & PaintedNet)
  | ({ type: 'mat' } & PaintedMat)
  | ({ type: 'draft' } & PaintedDraft)
  | { type: 'matrix'; matrix: MatrixPicture }
  | { type: 'nothing' };

/** Between two drawings in ms: events come no faster, and the eye asks for no more. */
const interval = 100;

/** Draws a flat picture, sharp at any size; of what comes in a short time only the last. */
export class Painter {
  private subject: PictureMessage = { type: 'nothing' };
  private size: PictureSize = { width: 0, height: 0, density: 1 };
  private readonly redraw = new Redraw(() => this.draw(), interval);

  private readonly context: Context2d | null;

  constructor(private readonly canvas: Canvas2d) {
    // Asked for once, because Firefox throws when a worker asks again. Kept from the graphics card, which is slow at
    // paths of thousands of corners: where software stands in for one, all else on the page would wait for them.
    this.context = canvas.getContext('2d', { willReadFrequently: true });
  }

  take(message: PictureMessage | CanvasMessage): void {
    if (message.type === 'end') return;
    if (message.type === 'size') this.size = message;
    else this.subject = message;
    this.redraw.request();
  }

  private draw(): void {
    const { context, subject } = this;
    const { width, height, density } = this.size;
    if (!context || width === 0 || height === 0) return;
    // Setting the size clears the canvas, too, and resets its transform.
    this.canvas.width = Math.round(width * density);
    this.canvas.height = Math.round(height * density);
    context.scale(density, density);
    if (subject.type === 'net') drawNet(context, width, height, subject);
    if (subject.type === 'mat') drawMat(context, width, height, subject);
    if (subject.type === 'draft') drawDraft(context, width, height, subject);
    if (subject.type === 'matrix') drawMatrix(context, width, height, subject.matrix);
  }
}
