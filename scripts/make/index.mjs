import { setUp } from '../setup/index.mjs';
import { buildEngine } from './engine.mjs';
import { buildWeb } from './web.mjs';

/** Sets up and builds everything that is shipped: the WASM module, the command line and the studio. */
export function build() {
  setUp();
  buildEngine('wasm', ['foldwright_wasm']);
  buildWeb();
}
