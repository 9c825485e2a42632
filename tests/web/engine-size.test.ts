import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { expect, it } from 'vitest';
import { isBuilt } from './command.js';

const module = fileURLToPath(new URL('../../dist/cli/foldwright.wasm', import.meta.url));

/** Bytes, compressed: every first run on a device waits for them. */
const budget = 600_000;

it.skipIf(!isBuilt)('the engine stays within its budget', () => {
  expect(gzipSync(readFileSync(module), { level: 9 }).length).toBeLessThan(budget);
});
