import type { Options } from '../../api/written-options.js';
import { extentsOf } from '../../model/bounds.js';
import { BadValue, decimal } from '../../model/option-values.js';
import { BadOption } from '../../words/bad-option.js';

/** Mm, as for `--height`. */
const millimetres = decimal(1, 100_000);

/** The options that are sizes along x, y (up) and z. */
const sides = ['width', 'height', 'depth'] as const;

/**
 * The option that makes the longest side of a model so long.
 *
 * @param written mm, as in an attribute
 * @param vertices 3 per vertex, y is up
 * @throws BadOption for what is no such length
 */
export function sizeOption(written: string, vertices: ArrayLike<number>): Options {
  const lengths = extentsOf(vertices);
  const longest = sides[lengths.indexOf(Math.max(...lengths))]!;
  try {
    return { [longest]: millimetres(written.trim()) };
  } catch (error) {
    if (!(error instanceof BadValue)) throw error;
    const option = 'target-size';
    throw new BadOption({ what: 'value', option, value: written, ...error.fault });
  }
}
