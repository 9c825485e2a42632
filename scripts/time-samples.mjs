/**
 * Unfolds each sample with the engine, as the studio does when nothing else is asked for, and writes into `catalog.json`
 * how many pieces come out and how long building them takes, by the formula of `web/model/building-time.ts`.
 */
import { readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { startPool, unfold } from '../dist/cli/index.js';

const samples = new URL('../web/app/public/samples/', import.meta.url);
const catalog = new URL('catalog.json', samples);

/** A module of the studio's own sources. */
async function source(path) {
  const { module } = await runnerImport(fileURLToPath(new URL(`../web/${path}`, import.meta.url)));
  return module;
}

const { buildingTime } = await source('model/building-time.ts');
const { creasesOf } = await source('model/assembly-steps.ts');
const pool = startPool();
const timed = [];
for (const sample of JSON.parse(await readFile(catalog, 'utf8'))) {
  const bytes = new Uint8Array(await readFile(new URL(sample.file, samples)));
  const { result } = await unfold([{ name: sample.file, bytes }], {}, { pool });
  const { glued } = buildingTime(
    result,
    result.pieces.map((piece) => creasesOf(piece)),
  );
  const building = { pieces: result.pieces.length, seconds: Math.round(glued) };
  timed.push({ ...sample, building });
}
pool.close();
await writeFile(catalog, `${JSON.stringify(timed, null, 2)}\n`);
