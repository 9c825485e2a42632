/** The smallest JPEG files: eight by eight pixels of one colour, in baseline mode. */

function segment(marker: number, data: readonly number[]): number[] {
  const length = data.length + 2;
  return [0xff, marker, length >> 8, length & 255, ...data];
}

/** A table in which the symbols 0 to 8 have codes of four bits each, or one symbol the code 0. */
function table(id: number, isSingle: boolean): number[] {
  const counts = Array.from({ length: 16 }, (_, i) => (isSingle ? +(i === 0) : i === 3 ? 9 : 0));
  const symbols = isSingle ? [0] : [0, 1, 2, 3, 4, 5, 6, 7, 8];
  return segment(0xc4, [id, ...counts, ...symbols]);
}

/** The mean of a block less 128, and that nothing else follows. */
function block(value: number): string {
  const size = value === 0 ? 0 : Math.abs(value).toString(2).length;
  const digits = value < 0 ? value + 2 ** size - 1 : value;
  const bits = size === 0 ? '' : digits.toString(2).padStart(size, '0');
  return `${size.toString(2).padStart(4, '0')}${bits}0`;
}

/** @param colour red, green and blue, which come back nearly the same */
export function jpegOf([red, green, blue]: readonly [number, number, number]): Uint8Array {
  const luma = 0.299 * red + 0.587 * green + 0.114 * blue;
  const channels = [luma - 128, (blue - luma) / 1.772, (red - luma) / 1.402].map(Math.round);
  const bits = channels.map(block).join('');
  const bytes = bits.padEnd(Math.ceil(bits.length / 8) * 8, '1').match(/.{8}/g)!;
  const scan = bytes.map((byte) => Number.parseInt(byte, 2));
  const parts = [1, 2, 3];
  return Uint8Array.from([
    ...[0xff, 0xd8],
    ...segment(0xdb, [0, ...Array<number>(64).fill(8)]),
    ...segment(0xc0, [8, 0, 8, 0, 8, 3, ...parts.flatMap((id) => [id, 0x11, 0])]),
    ...table(0, false),
    ...table(0x10, true),
    ...segment(0xda, [3, ...parts.flatMap((id) => [id, 0]), 0, 63, 0]),
    ...scan.flatMap((byte) => (byte === 0xff ? [byte, 0] : [byte])),
    ...[0xff, 0xd9],
  ]);
}
