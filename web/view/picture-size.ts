/** Of a picture on the page, in CSS pixels, and how many pixels each of them has. */
export interface PictureSize {
  width: number;
  height: number;
  density: number;
}

// More pixels than this cannot be seen and are slow to fill.
const mostDense = 2;

/** Tells the size of an element, at once and whenever it changes, until `life` ends. */
export function watchSize(
  frame: HTMLElement,
  life: AbortSignal,
  report: (size: PictureSize) => void,
): void {
  const observer = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = frame;
    report({ width, height, density: Math.min(window.devicePixelRatio, mostDense) });
  });
  observer.observe(frame);
  life.addEventListener('abort', () => observer.disconnect());
}
