import type { NetPicture } from '../model/job.js';
import { partColour } from '../model/part-colours.js';
import type { Context2d } from './context-2d.js';
import { boxAround } from './flat-net.js';
import { hatchFill } from './hatch-tile.js';
import { partHatch } from './part-hatches.js';

const ink = '#232a31';
const foldLine = 'rgb(35 42 49 / 55%)';
// Stronger and darker than any part, and see-through, so that layers show.
const overlapFill = 'rgb(214 20 30 / 72%)';
const overlapLine = '#7d0a12';

/** Free space around the net and size of the tiles of hatches, in CSS pixels. */
const margin = 8;
const tile = 10;

/** Above so many faces, edges are drawn thinner. */
const manyFaces = 600;

export interface PaintedNet {
  net: NetPicture;
  /** Per face of the net: its part. */
  parts: Int32Array;
  hatched: boolean;
}

/** A net's own origin in CSS pixels, with y down. */
export interface Placing {
  scale: number;
  x: number;
  y: number;
}

/** Places the net in the middle, as large as fits, with y down. */
function placeNet(corners: Float32Array, width: number, height: number): Placing {
  const box = boxAround(corners);
  const room = (length: number, extent: number): number => (length - 2 * margin) / (extent || 1);
  const scale = Math.min(room(width, box.width), room(height, box.height));
  return {
    scale,
    x: width / 2 - scale * (box.left + box.width / 2),
    y: height / 2 + scale * (box.low + box.height / 2),
  };
}

/** One path of the faces with this part, or of the overlapping ones, for each that occurs. */
function facePaths(
  { net, parts }: PaintedNet,
  { scale, x, y }: Placing,
): { ofParts: Map<number, Path2D>; overlapping: Path2D } {
  const ofParts = new Map<number, Path2D>();
  const overlapping = new Path2D();
  parts.forEach((part, face) => {
    let path = net.overlapping[face] ? overlapping : ofParts.get(part);
    if (!path) ofParts.set(part, (path = new Path2D()));
    const right = (corner: number): number => x + scale * net.corners[6 * face + 2 * corner]!;
    const down = (corner: number): number => y - scale * net.corners[6 * face + 2 * corner + 1]!;
    path.moveTo(right(0), down(0));
    path.lineTo(right(1), down(1));
    path.lineTo(right(2), down(2));
    // Closing it would take browsers the longer the more there is in the path.
    path.lineTo(right(0), down(0));
  });
  return { ofParts, overlapping };
}

/** Draws a net as large as fits into a canvas of this size. */
export function drawNet(
  context: Context2d,
  width: number,
  height: number,
  painted: PaintedNet,
): void {
  if (painted.parts.length === 0) return;
  paintNet(context, painted, placeNet(painted.net.corners, width, height));
}

/** Paints a net: faces in the colours of their parts, overlaps in red. */
export function paintNet(context: Context2d, painted: PaintedNet, placing: Placing): void {
  const { parts, hatched } = painted;
  const { ofParts, overlapping } = facePaths(painted, placing);
  context.lineJoin = 'round';
  // The more faces, the thinner their edges, or a large net would be all ink.
  const thin = Math.min(1, Math.sqrt(manyFaces / parts.length));
  context.lineWidth = 0.5 * thin;
  context.strokeStyle = foldLine;
  for (const [part, path] of ofParts) {
    const colour = partColour(part);
    context.fillStyle = hatched ? hatchFill(colour, ink, partHatch(part), tile) : colour;
    context.fill(path);
    context.stroke(path);
  }
  context.fillStyle = overlapFill;
  context.strokeStyle = overlapLine;
  context.lineWidth = thin;
  context.fill(overlapping);
  context.stroke(overlapping);
}
