/** Where pictures are drawn, in a document or in a worker. */
export type Context2d = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

/** A canvas, in a document or without one. */
export type AnyCanvas = HTMLCanvasElement | OffscreenCanvas;

/** What canvases of documents and those without one have in common. */
export interface Canvas2d {
  width: number;
  height: number;
  getContext(kind: '2d', options?: CanvasRenderingContext2DSettings): Context2d | null;
}

/** A canvas, in pixels, that is on no page. */
export function newCanvas(width: number, height: number): AnyCanvas {
  // A worker has no document; some browsers have no canvases without one.
  return typeof document === 'object'
    ? Object.assign(document.createElement('canvas'), { width, height })
    : new OffscreenCanvas(width, height);
}

/** What draws on a new canvas that is on no page. */
export function newContext(
  width: number,
  height: number,
  options?: CanvasRenderingContext2DSettings,
): Context2d {
  const canvas: Canvas2d = newCanvas(width, height);
  const context = canvas.getContext('2d', options);
  if (!context) throw new Error('This browser draws no canvases');
  return context;
}

/** A square canvas whose pixels are read. */
export function squareContext(size: number): Context2d {
  return newContext(size, size, { willReadFrequently: true });
}
