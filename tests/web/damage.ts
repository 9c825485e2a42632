/** Damages files as transport, storage and malice do, by a seed. */

/** Gives whole numbers below a bound. */
export type Numbers = (below: number) => number;

/** A generator of whole numbers below a bound (Numerical Recipes' constants). */
export function numbers(begin: number): Numbers {
  let state = begin >>> 0;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

function flipped(bytes: Uint8Array, below: Numbers): Uint8Array {
  const broken = bytes.slice();
  for (let left = 1 + below(8); left > 0; --left) {
    const at = below(bytes.length);
    broken[at]! ^= 1 << below(8);
  }
  return broken;
}

/** Counts and sizes at which readers are tempted to ask for too much, or to count below 0. */
const extremes = [0, 1, 0x7f, 0xff, 0x7fff, 0xffff, 0x10000, 0x7fffffff, 0x80000000, 0xffffffff];

function withExtreme(bytes: Uint8Array, below: Numbers): Uint8Array {
  const broken = bytes.slice();
  if (broken.length < 4) return broken;
  const view = new DataView(broken.buffer);
  view.setUint32(below(broken.length - 3), extremes[below(extremes.length)]!, below(8) > 0);
  return broken;
}

/** A stretch of the file is there twice, or not at all. */
function respliced(bytes: Uint8Array, below: Numbers): Uint8Array {
  const [from, to] = [below(bytes.length), below(bytes.length)];
  return Uint8Array.from([...bytes.subarray(0, from), ...bytes.subarray(to)]);
}

/** A file that is cut off, has other bits or numbers, or lacks or repeats a stretch. */
export function damaged(bytes: Uint8Array, below: Numbers): Uint8Array {
  switch (below(8)) {
    case 0:
      return bytes.slice(0, below(bytes.length));
    case 1:
    case 2:
      return withExtreme(bytes, below);
    case 3:
      return respliced(bytes, below);
    default:
      return flipped(bytes, below);
  }
}
