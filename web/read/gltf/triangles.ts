/** The triangles that a list of vertices stands for, by the mode of a primitive (glTF 2.0, section 3.7.2.1). */
import { unreadable } from '../unreadable.js';

export const modes = { triangles: 4, strip: 5, fan: 6 } as const;

/** A number that begins strips and fans anew is the largest of its type. */
function isRestart(index: number, indices: ArrayLike<number>): boolean {
  if (indices instanceof Uint8Array) return index === 0xff;
  if (indices instanceof Uint16Array) return index === 0xffff;
  return index === 0xffff_ffff;
}

function check(index: number, vertices: number, at: number): void {
  if (index < vertices) return;
  throw unreadable('bad-index', { what: 'beyond', first: 0, index, vertices, place: 'face', at });
}

function listed(indices: ArrayLike<number>, vertices: number): Uint32Array {
  const triangles = Uint32Array.from(indices).subarray(0, indices.length - (indices.length % 3));
  triangles.forEach((index, i) => check(index, vertices, Math.floor(i / 3)));
  return triangles;
}

/** Triangles of a strip, or of a fan around its first vertex; those without an area only join others. */
function chained(indices: ArrayLike<number>, vertices: number, isFan: boolean): Uint32Array {
  const triangles: number[] = [];
  let begin = 0;
  for (let i = 0; i < indices.length; ++i) {
    const last = indices[i]!;
    if (last >= vertices && isRestart(last, indices)) {
      begin = i + 1;
      continue;
    }
    check(last, vertices, Math.floor(triangles.length / 3));
    if (i - begin < 2) continue;
    const isTurned = !isFan && (i - begin) % 2 === 1;
    const [a, b] = [indices[isFan ? begin : i - 2]!, indices[i - 1]!];
    if (a === b || a === last || b === last) continue;
    triangles.push(...(isTurned ? [b, a] : [a, b]), last);
  }
  return Uint32Array.from(triangles);
}

/** 3 vertices per triangle. @throws Unreadable for an index beyond the vertices */
export function trianglesOf(
  indices: ArrayLike<number>,
  mode: number,
  vertices: number,
): Uint32Array {
  return mode === modes.triangles
    ? listed(indices, vertices)
    : chained(indices, vertices, mode === modes.fan);
}
