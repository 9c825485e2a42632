import type { NetPicture } from '../model/job.js';

/** A net as it lies on a mat: its corners from the lower left of its box on, wider than high. */
export interface FlatNet {
  /** 2 per corner, 3 corners per face; units of the model, y up. */
  corners: Float32Array;
  width: number;
  height: number;
}

/** Directions that are tried for a net, evenly over a right angle: enough for a box that is hardly too large. */
const directions = 15;

interface Box {
  left: number;
  low: number;
  width: number;
  height: number;
}

function turned(corners: Float32Array, angle: number): Float32Array {
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  const turnedCorners = new Float32Array(corners.length);
  for (let i = 0; i < corners.length; i += 2) {
    turnedCorners[i] = cosine * corners[i]! - sine * corners[i + 1]!;
    turnedCorners[i + 1] = sine * corners[i]! + cosine * corners[i + 1]!;
  }
  return turnedCorners;
}

/** The box around corners, given as x and y in turn. */
export function boxAround(corners: Float32Array): Box {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < corners.length; i += 2) {
    left = Math.min(left, corners[i]!);
    right = Math.max(right, corners[i]!);
    low = Math.min(low, corners[i + 1]!);
    high = Math.max(high, corners[i + 1]!);
  }
  return { left, low, width: right - left, height: high - low };
}

/** Turns a net so that it takes little room and lies on its long side. */
export function flatNet({ corners }: NetPicture): FlatNet {
  const tries = Array.from({ length: directions }, (_, i) => {
    const here = turned(corners, (i * Math.PI) / (2 * directions));
    return { here, box: boxAround(here) };
  });
  const area = ({ box }: (typeof tries)[number]): number => box.width * box.height;
  const best = tries.reduce((a, b) => (area(b) < area(a) ? b : a));
  const upright = best.box.height > best.box.width;
  const lying = upright ? turned(best.here, Math.PI / 2) : best.here;
  const { left, low, width, height } = boxAround(lying);
  const placed = lying.map((value, i) => value - (i % 2 === 0 ? left : low));
  return { corners: placed, width, height };
}

/** In place of a net whose shape is not known: a square of the same area. */
export function unknownNet(area: number): FlatNet {
  const side = Math.sqrt(area);
  return { corners: new Float32Array(), width: side, height: side };
}
