// A stamp is a file that holds a fingerprint of what a step depended on when it last succeeded.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { toolchain } from './paths.mjs';

export function fingerprint(...parts) {
  const hash = createHash('sha256');
  for (const part of parts) hash.update(part).update('\0');
  return hash.digest('hex');
}

/** Runs `step` unless it has succeeded with this fingerprint before. A step cut short is run again. */
export function once(name, print, step) {
  const file = join(toolchain, `${name}.stamp`);
  if (existsSync(file) && readFileSync(file, 'utf8') === print) return;
  rmSync(file, { force: true });
  mkdirSync(toolchain, { recursive: true });
  const start = Date.now();
  console.log(`setup: ${name} ...`);
  step();
  writeFileSync(file, print);
  console.log(`setup: ${name} done in ${((Date.now() - start) / 1000).toFixed(1)} s`);
}
