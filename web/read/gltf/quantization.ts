/** How coarse positions are that were stored in fewer bits than floats have. */

/** Values below which a pattern of bits may be chance. */
const fewest = 24;

/**
 * Bits that integers were made from: programs fill 16 bits with fewer by repeating the first ones behind the last.
 * All bits of their type unless every value shows such a repetition.
 */
function bitsOf(values: ArrayLike<number>, bits: number): number {
  const different = new Set<number>();
  for (let i = 0; i < values.length; ++i) different.add(Math.abs(values[i]!));
  if (different.size < fewest) return bits;
  for (let used = Math.ceil(bits / 2); used < bits; ++used) {
    const [low, high] = [bits - used, 2 * used - bits];
    const repeats = (value: number): boolean => {
      const first = value >> low;
      return value === ((first << low) | (first >> high));
    };
    if ([...different].every(repeats)) return used;
  }
  return bits;
}

/** The numbers that stored integers stand for, and the step between neighbouring ones. */
export interface Dequantized {
  values: Float64Array;
  step: number;
}

const signed = [Int8Array, Int16Array] as const;

/** @param isNormalized whether the largest integer stands for 1 */
export function dequantized(stored: ArrayLike<number>, isNormalized: boolean): Dequantized {
  const isSigned = signed.some((type) => stored instanceof type);
  const bits = 8 * ((stored as Partial<Uint8Array>).BYTES_PER_ELEMENT ?? 4) - (isSigned ? 1 : 0);
  const largest = isNormalized ? 2 ** bits - 1 : 1;
  // The least integer of a signed type stands for -1 as well.
  const values = Float64Array.from(stored, (value) =>
    Math.max(value / largest, isNormalized ? -1 : value),
  );
  const used = isNormalized && bits > 8 ? bitsOf(stored, bits) : bits;
  return { values, step: isNormalized ? 1 / (2 ** used - 1) : 1 };
}
