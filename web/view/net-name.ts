import type { Context2d } from './context-2d.js';

/** CSS pixels. */
const letterSize = 13;

const [halo, ink] = ['#fffefb', '#232a31'];

/** The middle of the face that lies nearest to the middle of all faces: a place on the net, whatever its shape. */
export function namePlace(corners: Float32Array): { x: number; y: number } {
  const faces = corners.length / 6;
  const middleOf = (face: number): [number, number] => {
    const at = 6 * face;
    const mean = (axis: number): number =>
      (corners[at + axis]! + corners[at + 2 + axis]! + corners[at + 4 + axis]!) / 3;
    return [mean(0), mean(1)];
  };
  const middles = Array.from({ length: faces }, (_, face) => middleOf(face));
  const sum = middles.reduce(([x, y], [u, v]) => [x + u, y + v], [0, 0]);
  const [x, y] = [sum[0] / faces, sum[1] / faces];
  const away = ([u, v]: [number, number]): number => Math.hypot(u - x, v - y);
  const [u, v] = middles.reduce((a, b) => (away(b) < away(a) ? b : a));
  return { x: u, y: v };
}

/** Writes the name of a net around a point, in CSS pixels, y down. */
export function writeName(context: Context2d, text: string, x: number, y: number): void {
  context.font = `600 ${letterSize}px system-ui, sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  context.lineWidth = 4;
  context.strokeStyle = halo;
  context.strokeText(text, x, y);
  context.fillStyle = ink;
  context.fillText(text, x, y);
}
