import { Inflate, Unzlib } from 'fflate';

/** Bytes that are unpacked at a time: what comes out of a bomb is noticed before it is large. */
const step = 16_384;

/** As far as the method goes: 258 bytes come of two bits. */
const mostGrowth = 1032;

const unpackers = { deflate: Inflate, zlib: Unzlib } as const;

/**
 * Unpacks bytes whose number is known.
 *
 * @throws Error unless just `size` bytes come out
 */
export function inflated(
  packed: Uint8Array,
  size: number,
  form: keyof typeof unpackers = 'deflate',
): Uint8Array {
  // Before memory is asked for.
  if (size > mostGrowth * packed.length) throw new Error('less comes out than was announced');
  const bytes = new Uint8Array(size);
  let at = 0;
  const unpacker = new unpackers[form]((chunk) => {
    if (at + chunk.length > size) throw new Error('more comes out than was announced');
    bytes.set(chunk, at);
    at += chunk.length;
  });
  for (let begin = 0; begin < packed.length; begin += step) {
    const end = begin + step;
    unpacker.push(packed.subarray(begin, end), end >= packed.length);
  }
  if (at !== size) throw new Error('less comes out than was announced');
  return bytes;
}
