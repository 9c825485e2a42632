import { pixelExcess, pixelSize } from '../model/pixels.js';
import { BadOption } from '../words/bad-option.js';
import { withPhysicalSize } from './png-resolution.js';
import { fontsOf, type Print } from './print.js';
import { renderSvg, startRenderer } from './renderer.js';
import { drawSvg } from './svg.js';

/**
 * One sheet, counted from 0, as a picture with white paper, which says how large it is: what is drawn
 * has true size when it is printed by that. All letters are outlines, so that no font of the system
 * matters, and the same print gives the same bytes in node and in browsers.
 *
 * @throws BadOption for a resolution that makes more pixels than can be drawn
 */
export async function writePng(print: Print, sheet: number): Promise<Uint8Array> {
  const { dpi, machine, sheets, loadRenderer } = print;
  const { width, height } = sheets[sheet]!;
  const excess = pixelExcess(width, height, dpi);
  if (excess !== null) throw new BadOption({ what: 'pixels', ...excess });
  const size = pixelSize(width, height, dpi);
  // Of whole pixels, and so a little larger than the sheet: nothing is stretched.
  const [right, bottom] = [size.width, size.height].map((pixels) => (pixels * 25.4) / dpi);
  const svg = drawSvg(
    { ...print, fonts: await fontsOf(print) },
    sheet,
    {
      width: String(size.width),
      height: String(size.height),
      viewBox: `0 0 ${right} ${bottom}`,
    },
    machine === 'none' ? 'filled' : 'drawn',
  );
  await startRenderer(loadRenderer);
  const png = renderSvg(svg, '#ffffff', (image) => image.asPng());
  return withPhysicalSize(png, dpi);
}
