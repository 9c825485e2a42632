import { describe, expect, it } from 'vitest';
import { lookOf } from '../../web/export/line-style.js';
import { defaultPrint } from '../../web/model/print-options.js';

type Rgb = [red: number, green: number, blue: number];

/** In shares of light, without the curve that files have. */
function lightOf(hex: string): Rgb {
  const channel = (at: number): number => {
    const value = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  };
  return [channel(1), channel(3), channel(5)];
}

const luminance = ([red, green, blue]: Rgb): number =>
  0.2126 * red + 0.7152 * green + 0.0722 * blue;

/** Contrast as WCAG reckons it. */
function contrast(one: Rgb, other: Rgb): number {
  const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (high! + 0.05) / (low! + 0.05);
}

/** What people without one kind of cones see (Machado, Oliveira and Fernandes 2009, severity 1). */
const eyes: Record<string, Rgb[]> = {
  protan: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deutan: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritan: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

function seen(matrix: Rgb[], light: Rgb): Rgb {
  const [red, green, blue] = matrix.map((row) =>
    Math.min(
      1,
      Math.max(
        0,
        row.reduce((sum, share, i) => sum + share * light[i]!, 0),
      ),
    ),
  );
  return [red!, green!, blue!];
}

/** Lightness and the two colour axes of CIELAB (white D65). */
function labOf([red, green, blue]: Rgb): number[] {
  const curve = (value: number): number =>
    value > 216 / 24389 ? Math.cbrt(value) : ((24389 / 27) * value + 16) / 116;
  const [x, y, z] = [
    curve((0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.9505),
    curve(luminance([red, green, blue])),
    curve((0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.089),
  ];
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

function difference(one: Rgb, other: Rgb): number {
  const [a, b] = [labOf(one), labOf(other)];
  return Math.hypot(...a.map((value, i) => value - b[i]!));
}

describe('the style foldwright', () => {
  const { lines, flaps, text } = lookOf(defaultPrint);
  const [mountain, valley] = [lightOf(lines.mountain.colour), lightOf(lines.valley.colour)];
  const white: Rgb = [1, 1, 1];

  it.each(Object.entries(eyes))('has folds that %s eyes tell apart', (_, matrix) => {
    // Differences of 2 to 3 are just seen; these are thin lines.
    expect(difference(seen(matrix, mountain), seen(matrix, valley))).toBeGreaterThan(40);
  });

  it('has folds that are as dark as each other in grey, and told by their dashes there', () => {
    expect(contrast(mountain, valley)).toBeLessThan(1.25);
    for (const fold of [mountain, valley]) expect(contrast(fold, white)).toBeGreaterThan(4.5);
    expect(lines.mountain.dash).toHaveLength(2);
    expect(lines.valley.dash).toHaveLength(4);
  });

  it('has flaps that are seen, and on which folds and numbers are', () => {
    const paper = lightOf(flaps);
    expect(contrast(paper, white)).toBeGreaterThan(1.2);
    expect(contrast(lightOf(text), paper)).toBeGreaterThan(7);
    for (const fold of [mountain, valley]) expect(contrast(fold, paper)).toBeGreaterThan(4);
  });
});
