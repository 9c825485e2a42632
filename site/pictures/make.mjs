// Makes all pictures of the site and the models that its viewers show, below build/site.
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../../scripts/setup/paths.mjs';
import { howPictures, shownModel, shownOptions } from './how-pictures.mjs';
import { optionPictures } from './option-pictures.mjs';
import { Runs } from './runs.mjs';

const folder = join(root, 'build/site');
const [pictures, models] = [join(folder, 'pictures'), join(folder, 'models')];

/** FOLD files for the viewers of the site's pages. */
async function writeModels(runs) {
  const shown = [
    [shownModel, shownOptions],
    ['house', { seed: 1 }],
  ];
  for (const [model, options] of shown) {
    const [{ name, bytes }] = await (await runs.session(model, options)).export('fold');
    writeFileSync(join(models, name), bytes);
  }
}

for (const name of [pictures, models]) {
  rmSync(name, { recursive: true, force: true });
  mkdirSync(name, { recursive: true });
}
const runs = new Runs();
try {
  const write = (name, data) => writeFileSync(join(folder, name), JSON.stringify(data, null, 1));
  write('how.json', await howPictures(runs, pictures));
  await writeModels(runs);
  write('options.json', await optionPictures(runs, pictures));
} finally {
  runs.close();
}
