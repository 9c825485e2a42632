/** PLY files as text. */

export function encode(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}

/** Lines that are joined at a time: one string for all of them may be longer than strings can be. */
const linesPerBlock = 10_000;

export function linesOf(count: number, line: (index: number) => string): Uint8Array[] {
  const blocks: Uint8Array[] = [];
  for (let first = 0; first < count; first += linesPerBlock) {
    const length = Math.min(linesPerBlock, count - first);
    const lines = Array.from({ length }, (_, i) => line(first + i));
    blocks.push(encode(`${lines.join('\n')}\n`));
  }
  return blocks;
}

export function concatenated(blocks: readonly Uint8Array[]): Uint8Array {
  const bytes = new Uint8Array(blocks.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const block of blocks) {
    bytes.set(block, at);
    at += block.length;
  }
  return bytes;
}

/** A place in a picture as text: nine digits tell all floats apart. */
export function placeWord(value: number): string {
  return Number.isNaN(value) ? 'nan' : String(Number(value.toPrecision(9)));
}
