#!/usr/bin/env node
/** Entry of the command line. */
import { exitStatus } from './exit.js';

// Before the rest is loaded, so that an early interrupt ends like a late one. Files are written in
// one go at the end: until then there is nothing to take back.
process.on('SIGINT', () => process.exit(exitStatus.cancelled));

const { main } = await import('./main.js');
await main(process.argv.slice(2));
