/** The package in a page or a worker. */
import { browserPool } from '../core/browser-pool.js';
import { makeDoor } from './door.js';
import { fetchFont } from './browser-fonts.js';

export const { open, unfold } = makeDoor({ startPool: () => browserPool(), loadFont: fetchFont });
export { browserPool as startPool };
export * from './exports.js';
