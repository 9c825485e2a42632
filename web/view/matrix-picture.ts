import type { MatrixPicture } from '../model/job.js';
import { squareContext, type Context2d } from './context-2d.js';

// Paper and ink as on the sheets, in the dark, too: darker is more likely.
const paper = [255, 254, 251] as const;
const ink = [35, 42, 49] as const;
const border = '#ad381e';

/** The matrix at one pixel per entry. */
function plainMatrix({ size, values }: MatrixPicture): CanvasImageSource {
  const context = squareContext(size);
  const image = context.createImageData(size, size);
  for (let i = 0; i < size * size; ++i) {
    const share = values[i]! / 255;
    for (let channel = 0; channel < 3; ++channel) {
      image.data[4 * i + channel] = paper[channel]! + (ink[channel]! - paper[channel]!) * share;
    }
    image.data[4 * i + 3] = 255;
  }
  context.putImageData(image, 0, 0);
  return context.canvas;
}

/** Frames the parts along the diagonal. */
function drawBlocks(context: Context2d, blocks: Int32Array, size: number, scale: number): void {
  context.strokeStyle = border;
  context.lineWidth = 1.5;
  blocks.forEach((first, index) => {
    const side = ((blocks[index + 1] ?? size) - first) * scale;
    context.strokeRect(first * scale, first * scale, side, side);
  });
}

/** Draws the foldability matrix as large as fits into the middle of a canvas of this size. */
export function drawMatrix(
  context: Context2d,
  width: number,
  height: number,
  matrix: MatrixPicture,
): void {
  if (matrix.size === 0) return;
  const side = Math.min(width, height);
  context.translate((width - side) / 2, (height - side) / 2);
  context.imageSmoothingEnabled = side < matrix.size;
  context.drawImage(plainMatrix(matrix), 0, 0, side, side);
  if (matrix.blocks) drawBlocks(context, matrix.blocks, matrix.size, side / matrix.size);
}
