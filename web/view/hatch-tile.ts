import { squareContext, type Context2d } from './context-2d.js';
import { hatchPaths, hatchTile, hatchWidth } from './part-hatches.js';

/** Draws one tile of a hatch, `size` pixels wide, over whatever `context` holds. */
function drawTile(context: Context2d, hatch: number, size: number): void {
  const scale = size / hatchTile;
  context.save();
  context.scale(scale, scale);
  context.lineWidth = hatchWidth;
  context.stroke(new Path2D(hatchPaths[hatch]));
  context.restore();
}

/** A fill for canvases: the colour with the hatch over it, in tiles of `size` pixels. */
export function hatchFill(colour: string, ink: string, hatch: number, size: number): CanvasPattern {
  const context = squareContext(size);
  context.fillStyle = colour;
  context.fillRect(0, 0, size, size);
  context.strokeStyle = ink;
  drawTile(context, hatch, size);
  const pattern = context.createPattern(context.canvas, 'repeat');
  if (!pattern) throw new Error('An empty tile makes no pattern');
  return pattern;
}

/** How much ink lies on each pixel of all hatches, 0 to 255: one square after the other. */
export function hatchInk(size: number): Uint8Array {
  const area = size * size;
  const ink = new Uint8Array(hatchPaths.length * area);
  hatchPaths.forEach((_path, hatch) => {
    const context = squareContext(size);
    drawTile(context, hatch, size);
    const { data } = context.getImageData(0, 0, size, size);
    for (let i = 0; i < area; ++i) ink[hatch * area + i] = data[4 * i + 3]!;
  });
  return ink;
}
