// Runs of the built package, the same engine and writers as the command has; equal runs are made once.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { open, startPool } from '../../dist/cli/index.js';
import { root } from '../../scripts/setup/paths.mjs';
import { tinyModels } from './tiny-models.mjs';

const samples = join(root, 'web/app/public/samples');

const catalog = JSON.parse(readFileSync(join(samples, 'catalog.json'), 'utf8'));

/** A sample by its id, or a tiny model by its name, as files in memory. */
function filesOf(model) {
  const tiny = tinyModels[model];
  if (tiny) {
    return Object.entries(tiny).map(([name, text]) => ({ name, bytes: Buffer.from(text) }));
  }
  const { files } = catalog.find(({ id }) => id === model);
  return files.map((name) => ({ name, bytes: readFileSync(join(samples, name)) }));
}

export class Runs {
  #pool = startPool(2);
  #sessions = new Map();

  /** A session in which the model was unfolded with these options. */
  async session(model, options, onEvent) {
    const key = JSON.stringify([model, options]);
    if (!this.#sessions.has(key)) {
      const session = await open(filesOf(model), { pool: this.#pool });
      await session.run(options, { onEvent, pictures: onEvent !== undefined });
      this.#sessions.set(key, session);
    }
    return this.#sessions.get(key);
  }

  close() {
    for (const session of this.#sessions.values()) session.close();
    this.#pool.close();
  }
}
