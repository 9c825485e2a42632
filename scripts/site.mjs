// The documentation site, in dist/site: `npm run site`.
import { build } from './make/index.mjs';
import { makeSite } from './make/site.mjs';
import { main } from './setup/shell.mjs';

main(() => {
  build();
  makeSite();
});
