import type { Footprint } from './sampler.js';

/** A slanted picture is sharper the more places are looked up; beyond, nobody sees it on paper. */
const mostSteps = 8;

/**
 * What a dot of paper covers of a picture.
 *
 * @param jacobian pixels of the picture, right and down, for a dot to the right and for one up
 */
export function footprintOf([xr, yr, xu, yu]: readonly [
  number,
  number,
  number,
  number,
]): Footprint {
  // The longest way across the ellipse that a round dot covers: an eigenvector of J times its transpose.
  const [xx, xy, yy] = [xr * xr + xu * xu, xr * yr + xu * yu, yr * yr + yu * yu];
  const middle = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  const long = Math.sqrt(middle + spread);
  const short = Math.sqrt(Math.max(0, middle - spread));
  const [x, y] = xx >= yy ? [middle + spread - yy, xy] : [xy, middle + spread - xx];
  const norm = Math.hypot(x, y) || 1;
  const [dx, dy] = [x / norm, y / norm];
  const level = Math.max(0, Math.floor(Math.log2(Math.max(short, long / mostSteps, 1))));
  const stepsOf = (length: number): number => Math.max(1, Math.ceil(length / 2 ** level - 1e-9));
  return {
    level,
    long: [dx * long, dy * long, stepsOf(long)],
    short: [-dy * short, dx * short, stepsOf(short)],
  };
}
