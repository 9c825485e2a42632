/** Both elements on a plain page of another origin than their files, in every engine. */
import { test } from 'vitest';
import { serveEmbedding } from '../e2e/embedding-site.js';
import { ring, unfoldedRing } from '../e2e/unfolded-ring.js';
import { useEmbedded } from './embedded-elements.js';
import { engines, useEngines } from './engines-fixture.js';

const made = unfoldedRing();
const withPage = useEngines(async () => {
  const { fold } = await made;
  return serveEmbedding({ 'model.fold': fold, 'model.obj': ring });
});

test.each(engines)('a page embeds both elements under its policy in $name', (engine) =>
  withPage(engine, async (studio) => {
    await useEmbedded(studio, (await made).hash);
    await studio.picture('6-embedded');
  }),
);
