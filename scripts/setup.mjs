// Sets the machine up for building (with --with-browser: for testing as well). Does nothing when all is there.
import { setUp } from './setup/index.mjs';
import { main } from './setup/shell.mjs';

main(() => setUp({ withBrowser: process.argv.includes('--with-browser') }));
