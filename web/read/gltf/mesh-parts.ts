/** The triangles of a glTF mesh in its own coordinates, or in the pose of its skin. */
import type { Accessor, Primitive } from '@gltf-transform/core';
import { composed, determinant, identity, mapped, stretch, type Affine } from '../matrix.js';
import { bitsOfSingle, halfSpacing, largestOf } from '../precision.js';
import type { Part } from '../soup.js';
import { dequantized } from './quantization.js';
import { RangeFault } from './range-fault.js';
import { affineOf } from './scene.js';
import { modes, trianglesOf } from './triangles.js';

/** Elements that do not fold. */
export interface Leftovers {
  points: number;
  lines: number;
}

/** Where the joints of a skin have moved what hangs at them. */
export type Pose = readonly Affine[];

interface Values {
  values: ArrayLike<number>;
  /** Rounding error of the positions. */
  error: number;
}

/** As they are stored. */
function numbersOf(accessor: Accessor): ArrayLike<number> | null {
  // Typed by the library with names that compilers of other settings do not know.
  return accessor.getArray() as ArrayLike<number> | null;
}

function valuesOf(accessor: Accessor): Values {
  const array = numbersOf(accessor);
  if (!array) throw new RangeFault();
  if (array instanceof Float64Array) return { values: array, error: 0 };
  if (array instanceof Float32Array) {
    return { values: array, error: halfSpacing(largestOf(array), bitsOfSingle) };
  }
  const { values, step } = dequantized(array, accessor.getNormalized());
  return { values, error: step / 2 };
}

/** Positions, with the shapes that are mixed in as the file has them at the beginning. */
function morphed(primitive: Primitive, weights: readonly number[]): Values {
  const { values, error } = valuesOf(primitive.getAttribute('POSITION')!);
  const targets = primitive.listTargets().map((target) => target.getAttribute('POSITION'));
  if (!targets.some((target, i) => target && weights[i])) return { values, error };
  const sum = Float64Array.from(values);
  targets.forEach((target, i) => {
    const weight = weights[i] ?? 0;
    if (!target || weight === 0) return;
    const moves = valuesOf(target).values;
    for (let k = 0; k < sum.length; ++k) sum[k]! += weight * (moves[k] ?? 0);
  });
  return { values: sum, error };
}

/** One vertex's share of each joint, of all sets of four. */
function* influences(primitive: Primitive, vertex: number): Generator<[number, number]> {
  for (let set = 0; ; ++set) {
    const joints = primitive.getAttribute(`JOINTS_${set}`);
    const weights = primitive.getAttribute(`WEIGHTS_${set}`);
    if (!joints || !weights) return;
    const [names, shares] = [joints.getElement(vertex, []), weights.getElement(vertex, [])];
    for (let i = 0; i < 4; ++i) yield [names[i]!, shares[i]!];
  }
}

/** A mean of maps by their shares, which need not sum up to 1. */
function blended(pose: Pose, shares: Iterable<[number, number]>): Affine {
  const sum = new Array<number>(12).fill(0);
  let total = 0;
  for (const [joint, share] of shares) {
    if (!(share > 0)) continue;
    const map = pose[joint];
    if (!map) throw new RangeFault();
    total += share;
    map.forEach((value, i) => (sum[i]! += share * value));
  }
  return total === 0 ? identity : sum.map((value) => value / total);
}

interface Posed extends Values {
  isMirrored: boolean;
}

function posed({ values, error }: Values, primitive: Primitive, pose: Pose): Posed {
  const result = new Float64Array(values.length);
  let [largest, mirrored] = [0, 0];
  for (let i = 0; i + 2 < values.length; i += 3) {
    const map = blended(pose, influences(primitive, i / 3));
    result.set(mapped(map, [values[i]!, values[i + 1]!, values[i + 2]!]), i);
    largest = Math.max(largest, stretch(map));
    mirrored += determinant(map) < 0 ? 1 : -1;
  }
  return { values: result, error: error * largest, isMirrored: mirrored > 0 };
}

/** The triangles of a primitive; null for one of points or lines, which is counted. */
export function partOf(
  primitive: Primitive,
  { weights, pose, step }: { weights: readonly number[]; pose: Pose | null; step: number },
  leftovers: Leftovers,
): Part | null {
  const positions = primitive.getAttribute('POSITION');
  if (!positions) return null;
  const count = positions.getCount();
  const listed = primitive.getIndices();
  const indices = (listed && numbersOf(listed)) ?? Uint32Array.from({ length: count }, (_, i) => i);
  const mode = primitive.getMode() as number;
  if (mode < modes.triangles) {
    if (mode === 0) leftovers.points += indices.length;
    else
      leftovers.lines +=
        mode === 1 ? Math.floor(indices.length / 2) : Math.max(0, indices.length - 1);
    return null;
  }
  const triangles = trianglesOf(indices, mode, count);
  const own = morphed(primitive, weights);
  const exact = { ...own, error: Math.max(own.error, step / 2) };
  if (!pose || !primitive.getAttribute('JOINTS_0')) {
    return { positions: exact.values, triangles, error: exact.error };
  }
  const { values, error, isMirrored } = posed(exact, primitive, pose);
  return { positions: values, triangles: isMirrored ? triangles.reverse() : triangles, error };
}

/** How a skin's joints have moved: each from where it lay when it was bound. */
export function poseOf(joints: readonly Affine[], unbound: Accessor | null): Pose {
  return joints.map((joint, i) => {
    const matrix = unbound?.getElement(i, []);
    if (!matrix) return joint;
    return composed(joint, affineOf(matrix));
  });
}
