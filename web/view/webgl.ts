/** Of a page or of a worker. */
interface Canvas {
  getContext(kind: 'webgl2', options: WebGLContextAttributes): WebGL2RenderingContext | null;
}

/** Starts WebGL 2 on a canvas, with smooth edges over whatever lies below; null where there is none. */
export function startWebGl(canvas: Canvas): WebGL2RenderingContext | null {
  const options: WebGLContextAttributes = { alpha: true, antialias: true };
  return canvas.getContext('webgl2', options);
}

/** Whether software stands in for a graphics card, and so takes its time from whatever else runs. */
export function drawsInSoftware(context: WebGL2RenderingContext): boolean {
  // Browsers that keep the name to themselves are taken to have a card.
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const name = names ? String(context.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
