import { defineConfig } from 'vitest/config';

/**
 * Five groups: what runs under node, what drives Chromium over the built studio, what drives three engines, what takes
 * up the packed package, and what reads the documentation site and runs its examples.
 */
export default defineConfig({
  test: {
    projects: [
      {
        test: {
          name: 'web',
          include: ['tests/web/**/*.test.ts'],
          // By default one core is left free: of two that would be half of them.
          maxWorkers: '100%',
          maxConcurrency: 2,
          // A whole job in WASM takes seconds on a slow machine.
          testTimeout: 250_000,
        },
      },
      {
        test: {
          name: 'browser',
          include: ['tests/e2e/**/*.test.ts'],
          // A browser waits for its page and its workers by turns, so two are done sooner than one after the other.
          maxWorkers: 2,
          // After all others.
          sequence: { groupOrder: 1 },
          testTimeout: 120_000,
          hookTimeout: 60_000,
          // A second, as it is by default, is not enough for a worker's answer on a busy machine.
          expect: { poll: { timeout: 20_000 } },
        },
      },
      {
        test: {
          name: 'engines',
          include: ['tests/browsers/**/*.test.ts'],
          fileParallelism: false,
          sequence: { groupOrder: 2 },
          testTimeout: 180_000,
          hookTimeout: 60_000,
        },
      },
      {
        test: {
          name: 'package',
          include: ['tests/package/**/*.test.ts'],
          fileParallelism: false,
          sequence: { groupOrder: 3 },
          // Bundlers and whole jobs take their time on a slow machine.
          testTimeout: 600_000,
          hookTimeout: 120_000,
        },
      },
      {
        test: {
          name: 'site',
          include: ['tests/site/**/*.test.ts'],
          fileParallelism: false,
          sequence: { groupOrder: 4 },
          // Examples unfold whole models, those of one page in a row.
          testTimeout: 300_000,
          hookTimeout: 60_000,
          expect: { poll: { timeout: 20_000 } },
        },
      },
    ],
  },
});
