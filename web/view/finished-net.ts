import type { NetPicture, Piece } from '../model/job.js';

/** The picture of a net that is finished, and so has no overlaps. */
export function finishedNet({ vertices, faces, sources }: Piece): NetPicture {
  const corners = new Float32Array(2 * faces.length);
  faces.forEach((vertex, corner) => {
    corners[2 * corner] = vertices[2 * vertex]!;
    corners[2 * corner + 1] = vertices[2 * vertex + 1]!;
  });
  return { corners, sources, overlapping: new Uint8Array(sources.length) };
}
