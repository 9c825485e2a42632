import { build } from './make/index.mjs';
import { main } from './setup/shell.mjs';

main(build);
