import { zlibSync } from 'fflate';
import { pngAround, type PngSize } from '../../model/png-file.js';

/** Colours in rows from above. */
export interface ColourRows extends PngSize {
  /** `channels` per dot. */
  values: Uint8Array;
}

/** Whichever of left and above, and left above both, is nearest to what they would be on a slope. */
function paeth(left: number, above: number, corner: number): number {
  const slope = left + above - corner;
  const [a, b, c] = [Math.abs(slope - left), Math.abs(slope - above), Math.abs(slope - corner)];
  if (a <= b && a <= c) return left;
  return b <= c ? above : corner;
}

/** Filters of PNG by their numbers: what is taken off a value. */
const guesses = [
  (): number => 0,
  (left: number): number => left,
  (_: number, above: number): number => above,
  null,
  paeth,
] as const;

// A mean of two packs worse than the others nearly always.
const tried = [0, 1, 2, 4] as const;

type Filter = (typeof tried)[number];

/** Calls with every `step`th value of a row and what a filter leaves of it. */
function filterRow(
  { values, channels, width }: ColourRows,
  row: number,
  filter: Filter,
  step: number,
  found: (i: number, rest: number) => void,
): void {
  const guess = guesses[filter];
  const stride = channels * width;
  const start = row * stride;
  for (let i = 0; i < stride; i += step) {
    const at = start + i;
    const left = i >= channels ? values[at - channels]! : 0;
    const above = row > 0 ? values[at - stride]! : 0;
    const corner = row > 0 && i >= channels ? values[at - stride - channels]! : 0;
    found(i, (values[at]! - guess(left, above, corner)) & 255);
  }
}

/** So many values of a row tell which filter suits it; no multiple of 3 or 4, so all channels count. */
const sampleStep = 13;

/** The filter that leaves the least. */
function bestFilter(rows: ColourRows, row: number): Filter {
  let [best, least]: [Filter, number] = [0, Infinity];
  for (const filter of tried) {
    let sum = 0;
    filterRow(rows, row, filter, sampleStep, (_, rest) => {
      sum += rest < 128 ? rest : 256 - rest;
    });
    if (sum < least) [best, least] = [filter, sum];
  }
  return best;
}

/** Colours as PNG files and PDF images hold them: filtered row by row, and compressed. */
export function packedRows(rows: ColourRows): Uint8Array {
  const stride = rows.channels * rows.width;
  const filtered = new Uint8Array(rows.height * (stride + 1));
  for (let row = 0; row < rows.height; ++row) {
    const start = row * (stride + 1);
    const filter = bestFilter(rows, row);
    filtered[start] = filter;
    filterRow(rows, row, filter, 1, (i, rest) => {
      filtered[start + 1 + i] = rest;
    });
  }
  return zlibSync(filtered);
}

/** A PNG file; the same colours give the same bytes. */
export function pngFile(rows: ColourRows): Uint8Array {
  return pngAround(rows, packedRows(rows));
}
