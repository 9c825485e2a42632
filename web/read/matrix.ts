/** Affine maps as 12 numbers: three columns, then the translation. */
export type Affine = readonly number[];

export const identity: Affine = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];

/** First `inner`, then `outer`. */
export function composed(outer: Affine, inner: Affine): Affine {
  const result: number[] = [];
  for (let column = 0; column < 4; ++column) {
    const at = 3 * column;
    for (let row = 0; row < 3; ++row) {
      const moved = column === 3 ? outer[9 + row]! : 0;
      result.push(
        outer[row]! * inner[at]! +
          outer[3 + row]! * inner[at + 1]! +
          outer[6 + row]! * inner[at + 2]! +
          moved,
      );
    }
  }
  return result;
}

export function scaling(factor: number): Affine {
  return [factor, 0, 0, 0, factor, 0, 0, 0, factor, 0, 0, 0];
}

/** Negative for a map that mirrors. */
export function determinant(m: Affine): number {
  return (
    m[0]! * (m[4]! * m[8]! - m[7]! * m[5]!) -
    m[3]! * (m[1]! * m[8]! - m[7]! * m[2]!) +
    m[6]! * (m[1]! * m[5]! - m[4]! * m[2]!)
  );
}

/** A bound of how much longer a small vector becomes. */
export function stretch(m: Affine): number {
  return Math.max(...[0, 3, 6].map((at) => Math.hypot(m[at]!, m[at + 1]!, m[at + 2]!)));
}

/** Maps points, 3 numbers each. Where the map is the identity, no bit changes. */
export function mapped(m: Affine, points: ArrayLike<number>): Float64Array {
  const result = Float64Array.from(points);
  if (m.every((value, i) => value === identity[i])) return result;
  for (let i = 0; i + 2 < result.length; i += 3) {
    const [x, y, z] = [result[i]!, result[i + 1]!, result[i + 2]!];
    for (let row = 0; row < 3; ++row) {
      result[i + row] = m[row]! * x + m[3 + row]! * y + m[6 + row]! * z + m[9 + row]!;
    }
  }
  return result;
}
