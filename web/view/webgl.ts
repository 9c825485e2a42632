/** Starts WebGL 2 on a canvas, with smooth edges over whatever lies below; null where there is none. */
export function startWebGl(
  canvas: HTMLCanvasElement | OffscreenCanvas,
): WebGL2RenderingContext | null {
  const options: WebGLContextAttributes = { alpha: true, antialias: true };
  return canvas.getContext('webgl2', options) as WebGL2RenderingContext | null;
}
