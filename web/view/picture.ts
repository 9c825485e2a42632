import { Redraw } from './redraw.js';

/** Paints a cleared canvas of this size, in CSS pixels. */
export type Paint = (context: CanvasRenderingContext2D, width: number, height: number) => void;

/** Between two drawings in ms: events come no faster, and the eye asks for no more. */
const interval = 100;

// More pixels than this cannot be seen and are slow to fill.
const mostDense = 2;

/** A canvas that stays sharp whatever its size on the page, drawn when asked for. */
export class Picture {
  private readonly redraw = new Redraw(() => this.draw(), interval);

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly paint: Paint,
  ) {
    new ResizeObserver(() => this.request()).observe(canvas);
  }

  /** Draws in one of the next frames. */
  request(): void {
    this.redraw.request();
  }

  private draw(): void {
    const { clientWidth, clientHeight } = this.canvas;
    const context = this.canvas.getContext('2d');
    if (!context || clientWidth === 0 || clientHeight === 0) return;
    const density = Math.min(window.devicePixelRatio, mostDense);
    // Setting the size clears the canvas, too, and resets its transform.
    this.canvas.width = Math.round(clientWidth * density);
    this.canvas.height = Math.round(clientHeight * density);
    context.scale(density, density);
    this.paint(context, clientWidth, clientHeight);
  }
}
