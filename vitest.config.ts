import { defineConfig } from 'vitest/config';

/** Two groups: what runs under node, and what drives a browser over the built studio. */
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
          testTimeout: 60_000,
        },
      },
      {
        test: {
          name: 'browser',
          include: ['tests/e2e/**/*.test.ts'],
          // One browser at a time: WebGL is drawn in software here and takes all cores.
          fileParallelism: false,
          // After all others.
          sequence: { groupOrder: 1 },
          testTimeout: 120_000,
          hookTimeout: 60_000,
        },
      },
    ],
  },
});
