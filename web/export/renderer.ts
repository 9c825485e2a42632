import { initWasm, Resvg } from '@resvg/resvg-wasm';
import type { RendererLoader } from './renderer-loader.js';

let ready: Promise<void> | null = null;

/** Starts the renderer once in each thread: it refuses a second time. */
export function startRenderer(load: RendererLoader): Promise<void> {
  ready ??= load('resvg').then(initWasm);
  // Another try may succeed.
  ready.catch(() => (ready = null));
  return ready;
}

type RenderedImage = ReturnType<InstanceType<typeof Resvg>['render']>;

/**
 * What comes of an SVG document, which has letters as outlines only.
 *
 * @param background behind it, or nothing
 * @param take gets the picture, whose memory ends with the call
 */
export function renderSvg<Taken>(
  svg: string,
  background: string | undefined,
  take: (image: RenderedImage) => Taken,
): Taken {
  const drawing = new Resvg(svg, {
    ...(background !== undefined && { background }),
    font: { loadSystemFonts: false },
  });
  try {
    const image = drawing.render();
    try {
      return take(image);
    } finally {
      image.free();
    }
  } finally {
    drawing.free();
  }
}
