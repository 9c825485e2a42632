import type { JobResult, Piece } from './job.js';

/** The vertices of the model that those of a piece are. */
export function modelVertices(
  { faces, sources, vertices }: Piece,
  model: JobResult['model'],
): Int32Array {
  const found = new Int32Array(vertices.length / 2);
  faces.forEach((vertex, at) => {
    found[vertex] = model.faces[3 * sources[Math.floor(at / 3)]! + (at % 3)]!;
  });
  return found;
}
