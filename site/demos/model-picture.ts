/** A model in the colours of its parts, in parallel projection; far faces first. */
import { partColour } from '../../web/model/part-colours.js';

/** Free space around it in CSS pixels, and how far it is seen from above. */
const [margin, tilt] = [10, 0.35];
const plain = '#d9d0bd';
const light = [-0.45, 0.75, 0.5] as const;

export interface ShownModel {
  vertices: Float32Array;
  faces: Int32Array;
  /** Per face; null before there are parts. */
  labels: Int32Array | null;
}

/** The points as they are seen after a turn about the axis that points up: x, y and depth of each. */
function seenFrom(vertices: Float32Array, turn: number): Float32Array {
  const seen = new Float32Array(vertices.length);
  const [sine, cosine] = [Math.sin(turn), Math.cos(turn)];
  const [down, across] = [Math.sin(tilt), Math.cos(tilt)];
  for (let i = 0; i < vertices.length; i += 3) {
    const [x, y, z] = [vertices[i]!, vertices[i + 1]!, vertices[i + 2]!];
    const near = cosine * z - sine * x;
    seen.set([cosine * x + sine * z, across * y - down * near, down * y + across * near], i);
  }
  return seen;
}

/** How much light a face gets, from its corners as they are seen, as a share. */
function lightOn(corners: readonly (readonly number[])[]): number {
  const [a, b, c] = corners as [number[], number[], number[]];
  const [u, v] = [b, c].map((point) => point.map((value, axis) => value - a[axis]!)) as [
    number[],
    number[],
  ];
  const normal = [0, 1, 2].map((axis) => {
    const [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
    return u[next]! * v[last]! - u[last]! * v[next]!;
  });
  const along = normal.reduce((sum, value, axis) => sum + value * light[axis]!, 0);
  return Math.abs(along) / (Math.hypot(...normal) || 1);
}

/** Scale and middle with which all points fit into a canvas. */
function placing(seen: Float32Array, width: number, height: number): (point: number[]) => number[] {
  const range = (axis: number): [number, number] => {
    let [least, most] = [Infinity, -Infinity];
    for (let i = axis; i < seen.length; i += 3) {
      least = Math.min(least, seen[i]!);
      most = Math.max(most, seen[i]!);
    }
    return [least, most];
  };
  const [[left, right], [low, high]] = [range(0), range(1)];
  const scale = Math.min(
    (width - 2 * margin) / (right - left || 1),
    (height - 2 * margin) / (high - low || 1),
  );
  return ([x, y]) => [
    width / 2 + scale * (x! - (left + right) / 2),
    height / 2 - scale * (y! - (low + high) / 2),
  ];
}

/** Draws the model as large as fits; pixels are CSS pixels. */
export function drawModel(
  context: CanvasRenderingContext2D,
  [width, height]: readonly [number, number],
  { vertices, faces, labels }: ShownModel,
  turn: number,
): void {
  const seen = seenFrom(vertices, turn);
  const place = placing(seen, width, height);
  const cornersOf = (face: number): number[][] =>
    [0, 1, 2].map((corner) => {
      const at = 3 * faces[3 * face + corner]!;
      return [seen[at]!, seen[at + 1]!, seen[at + 2]!];
    });
  const shapes = Array.from({ length: faces.length / 3 }, (_, face) => {
    const corners = cornersOf(face);
    return { face, corners, depth: corners.reduce((sum, corner) => sum + corner[2]!, 0) };
  }).sort((one, other) => one.depth - other.depth);
  context.lineJoin = 'round';
  context.lineWidth = 0.6;
  for (const { face, corners } of shapes) {
    const path = new Path2D(`M${corners.map((corner) => place(corner).join(' ')).join('L')}Z`);
    context.fillStyle = labels ? partColour(labels[face]!) : plain;
    context.fill(path);
    context.fillStyle = `rgb(35 42 49 / ${45 * (1 - lightOn(corners))}%)`;
    context.fill(path);
    context.strokeStyle = 'rgb(35 42 49 / 35%)';
    context.stroke(path);
  }
}
