/** A model and a pencil side by side, in millimetres and flat, as someone sees them who stands before a table. */
import { boxOf } from '../model/bounds.js';

type Numbers = Float32Array | Float64Array;

/** A thing on the table as the data of an SVG path, in mm; y is down, its left lower corner is at 0, 0. */
export interface Silhouette {
  path: string;
  width: number;
  height: number;
}

/** Decimals of a mm that are worth their room in the path. */
const decimals = 1;

/** Length and thickness of a new pencil in mm. */
export const pencil = { length: 175, width: 7.5 } as const;

/** Tip of the lead and of the wood of a pencil that stands on its end, in mm. */
const [lead, wood] = [4, 20];

/**
 * The shadow of a mesh on the wall behind it. All its triangles are in the path, turned the same way round so that
 * they fill it together.
 *
 * @param scale mm per unit of the mesh
 */
export function silhouetteOf(vertices: Numbers, faces: Int32Array, scale: number): Silhouette {
  const {
    low: [left, low],
    high: [right, high],
  } = boxOf(vertices);
  const x = (vertex: number): number => scale * (vertices[3 * vertex]! - left);
  const y = (vertex: number): number => scale * (low - vertices[3 * vertex + 1]!);
  const point = (vertex: number): string =>
    `${x(vertex).toFixed(decimals)} ${y(vertex).toFixed(decimals)}`;
  const triangles: string[] = [];
  for (let i = 0; i < faces.length; i += 3) {
    const [a, b, c] = [faces[i]!, faces[i + 1]!, faces[i + 2]!];
    const area = (x(b) - x(a)) * (y(c) - y(a)) - (x(c) - x(a)) * (y(b) - y(a));
    const corners = area < 0 ? [a, c, b] : [a, b, c];
    triangles.push(`M${corners.map(point).join(' ')}z`);
  }
  return { path: triangles.join(''), width: scale * (right - left), height: scale * (high - low) };
}

/** A pencil that stands on its end: its outline, and the line between paint and wood. */
export function pencilPath(): string {
  const { length, width } = pencil;
  const shaft = wood - length;
  const share = lead / wood;
  const [from, to] = [(width * (1 - share)) / 2, (width * (1 + share)) / 2];
  return (
    `M0 0V${shaft}L${width / 2} ${-length}L${width} ${shaft}V0z` +
    `M0 ${shaft}H${width}M${from} ${lead - length}H${to}`
  );
}
