/** Of a canvas on the page, in CSS pixels, and how many pixels each of them has. */
export interface CanvasSize {
  width: number;
  height: number;
  density: number;
}

// More pixels than this cannot be seen and are slow to fill.
const mostDense = 2;

/** Tells the size of a canvas, at once and whenever it changes. */
export function watchSize(canvas: HTMLCanvasElement, tell: (size: CanvasSize) => void): void {
  new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = canvas;
    tell({ width, height, density: Math.min(window.devicePixelRatio, mostDense) });
  }).observe(canvas);
}
