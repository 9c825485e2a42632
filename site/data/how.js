// Figures of the run whose pictures the pages about how it works show; `site/pictures/make.mjs` has left them.
import { readFileSync } from 'node:fs';

export default () => JSON.parse(readFileSync('build/site/how.json', 'utf8'));
