import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { expect } from 'vitest';

const folder = new URL('../data/', import.meta.url);

/** Three decimals: a micrometre, so that only changes count that a person could ever see. */
function rounded(text: string): string {
  const long = /-?\d+(\.\d{4,}|(\.\d+)?e-?\d+)/g;
  return text.replace(long, (number) => String(Number(Number(number).toFixed(3)) + 0));
}

/**
 * Compares a text with the file of this name in tests/data, numbers rounded. A text that differs is
 * written beside it as NAME-changed.EXT.
 */
export function expectGolden(name: string, text: string): void {
  const golden = new URL(name, folder);
  const changed = new URL(name.replace(/(\.\w+)$/, '-changed$1'), folder);
  const actual = rounded(text);
  const expected = existsSync(golden) ? readFileSync(golden, 'utf8') : '';
  if (actual === expected) rmSync(changed, { force: true });
  else writeFileSync(changed, actual);
  expect(actual === expected, `${name} differs, see ${changed.pathname}`).toBe(true);
}
