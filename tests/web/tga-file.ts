/** Writes TGA files for tests. */
export interface TgaSpec {
  kind: 'table' | 'colours' | 'grey';
  /** Bits per pixel. */
  depth: number;
  isPacked?: boolean;
  isFromAbove?: boolean;
  isFromRight?: boolean;
  alphaBits?: number;
}

const kinds = { table: 1, colours: 2, grey: 3 };

/** Packets of runs and of pixels as they are, in turn. */
function packed(pixels: readonly (readonly number[])[]): number[] {
  const bytes: number[] = [];
  for (let at = 0; at < pixels.length;) {
    let run = 1;
    while (run < 128 && pixels[at + run]?.join() === pixels[at]!.join()) ++run;
    if (run > 1) bytes.push(127 + run, ...pixels[at]!);
    else bytes.push(0, ...pixels[at]!);
    at += run;
  }
  return bytes;
}

/**
 * @param pixels each as its bytes are stored, in the order in which they are stored
 * @param table three bytes per colour
 */
export function tgaOf(
  { kind, depth, alphaBits = 0, ...spec }: TgaSpec,
  [width, height]: readonly [number, number],
  pixels: readonly (readonly number[])[],
  table: readonly number[] = [],
): Uint8Array {
  const type = kinds[kind] + (spec.isPacked ? 8 : 0);
  const colours = table.length / 3;
  const word = (value: number): number[] => [value & 255, value >> 8];
  const descriptor = alphaBits + (spec.isFromRight ? 16 : 0) + (spec.isFromAbove ? 32 : 0);
  const header = [
    ...[2, colours > 0 ? 1 : 0, type],
    ...[...word(0), ...word(colours), colours > 0 ? 24 : 0],
    ...[0, 0, 0, 0, ...word(width), ...word(height), depth, descriptor],
  ];
  // A comment of two bytes stands before the colours.
  const content = spec.isPacked ? packed(pixels) : pixels.flat();
  return Uint8Array.from([...header, 1, 2, ...table, ...content]);
}
