// A stamp is a file that holds a fingerprint of what a step depended on when it last succeeded.
import { createHash } from 'node:crypto';
import {
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { toolchain } from './paths.mjs';

export function fingerprint(...parts) {
  const hash = createHash('sha256');
  for (const part of parts) hash.update(part).update('\0');
  return hash.digest('hex');
}

/**
 * Runs `step` unless it has succeeded with this fingerprint before and its outputs are still there. A step cut short
 * is run again.
 */
export function once(name, print, step, outputs = []) {
  const file = join(toolchain, `${name}.stamp`);
  const isDone = existsSync(file) && readFileSync(file, 'utf8') === print;
  if (isDone && outputs.every((output) => existsSync(output))) return;
  rmSync(file, { force: true });
  mkdirSync(toolchain, { recursive: true });
  const start = Date.now();
  console.log(`${name} ...`);
  step();
  writeFileSync(file, print);
  console.log(`${name} done in ${((Date.now() - start) / 1000).toFixed(1)} s`);
}

/** A fingerprint of the contents of files and of everything below folders; what is absent counts as empty. */
export function contentFingerprint(paths) {
  const parts = [];
  for (const path of [...paths].sort()) {
    if (!existsSync(path)) continue;
    if (!statSync(path).isDirectory()) parts.push(path, readFileSync(path));
    else parts.push(contentFingerprint(readdirSync(path).map((name) => join(path, name))));
  }
  return fingerprint(...parts);
}
