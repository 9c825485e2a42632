/** Small pictures of models for lists. */
import { base64 } from '../export/texture/base64.js';
import { viewFrom, type View } from '../export/view-direction.js';
import type { Model } from '../model/job.js';
import { partRgb } from '../model/part-colours.js';
import { cross, dot, minus, times, type Vector } from '../model/vector.js';
import { newContext, type Context2d } from '../view/context-2d.js';

/** What is shown of a model. */
export interface Portrait extends Pick<Model, 'vertices' | 'faces'> {
  /** Per face: its part, in whose colour it is. */
  labels: Int32Array;
}

/** Pixels of a side; shown at half of that, for sharp screens. */
const size = 192;
const margin = 8;

/** More faces than pixels show are drawn one in so many. */
const mostFaces = 40_000;

/** How dark a face is that is seen from its side. */
const shade = 0.6;

interface Tile {
  corners: [number, number][];
  depth: number;
  colour: string;
}

const light: Vector = [0.35, 0.8, 0.5];

function tilesOf({ vertices, faces, labels }: Portrait, { right, up, towards }: View): Tile[] {
  const at = (v: number): Vector => [vertices[3 * v]!, vertices[3 * v + 1]!, vertices[3 * v + 2]!];
  const count = faces.length / 3;
  const step = Math.ceil(count / mostFaces);
  const tiles: Tile[] = [];
  for (let face = 0; face < count; face += step) {
    const [a, b, c] = [0, 1, 2].map((corner) => at(faces[3 * face + corner]!)) as [
      Vector,
      Vector,
      Vector,
    ];
    const normal = cross(minus(b, a), minus(c, a));
    const length = Math.sqrt(dot(normal, normal));
    if (length === 0) continue;
    const brightness = shade + (1 - shade) * Math.max(0, dot(times(normal, 1 / length), light));
    const rgb = partRgb(labels[face] ?? 0).map((value) => Math.round(value * brightness));
    tiles.push({
      corners: [a, b, c].map((corner) => [dot(corner, right), -dot(corner, up)]),
      depth: dot(a, towards) + dot(b, towards) + dot(c, towards),
      colour: `rgb(${rgb.join(' ')})`,
    });
  }
  // What is nearer covers what is behind it.
  return tiles.sort((one, other) => one.depth - other.depth);
}

function draw(context: Context2d, tiles: readonly Tile[]): void {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of tiles.flatMap(({ corners }) => corners)) {
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
  }
  const scale = (size - 2 * margin) / Math.max(right - left, bottom - top, 1e-9);
  const x0 = size / 2 - (scale * (left + right)) / 2;
  const y0 = size / 2 - (scale * (top + bottom)) / 2;
  context.lineJoin = 'round';
  for (const { corners, colour } of tiles) {
    context.beginPath();
    for (const [x, y] of corners) context.lineTo(x0 + scale * x, y0 + scale * y);
    context.closePath();
    // The stroke closes the gaps between faces.
    context.fillStyle = context.strokeStyle = colour;
    context.fill();
    context.stroke();
  }
}

/** A picture as a data: address; empty where this browser draws none in workers. */
export async function thumbnail(portrait: Portrait): Promise<string> {
  try {
    const context = newContext(size, size);
    draw(context, tilesOf(portrait, viewFrom('front-left')));
    const blob = await (context.canvas as OffscreenCanvas).convertToBlob({ type: 'image/png' });
    return `data:image/png;base64,${base64(new Uint8Array(await blob.arrayBuffer()))}`;
  } catch {
    // Nothing depends on it.
    return '';
  }
}
