import { build } from './build/index.mjs';
import { main } from './setup/shell.mjs';

main(build);
