/** Where pictures are drawn, in a document or in a worker. */
export type Context2d = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

/** What canvases of documents and those without one have in common. */
export interface Canvas2d {
  width: number;
  height: number;
  getContext(kind: '2d', options?: CanvasRenderingContext2DSettings): Context2d | null;
}

/** A square canvas, in pixels, that is on no page. */
export function squareContext(size: number): Context2d {
  // A worker has no document; some browsers have no canvases without one.
  const canvas =
    typeof document === 'object'
      ? Object.assign(document.createElement('canvas'), { width: size, height: size })
      : new OffscreenCanvas(size, size);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('This browser draws no canvases');
  return context;
}
