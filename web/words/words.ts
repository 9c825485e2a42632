import type { english } from './en/index.js';

/** All that people read, in one language: sentences and the functions that make them. The English ones are the pattern. */
export type Words = typeof english;
