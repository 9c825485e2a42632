// Our simplification beside OpenMesh's and meshoptimizer's on the nine organic models of 5000 faces and the full scans:
// how far the surface moves (largest and mean distance, percent of the diagonal), the sharpest corner, faces with corners
// of less than 15 degrees and with an altitude of less than 15 % of a usual edge, pairs of faces that run through each
// other, and processor seconds. Takes the native build as it is. Arguments: numbers of faces.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { MeshoptSimplifier } from 'meshoptimizer';
import { runnerImport } from 'vite';

const { module } = await runnerImport(fileURLToPath(new URL('../web/command.ts', import.meta.url)));
const shared = module.sharedFolder();
const program = fileURLToPath(new URL('../../build/release/bench_simplify', import.meta.url));
const given = process.argv.slice(2).map(Number);
const sizes = given.length > 0 ? given : [200, 500, 1000, 1500];

/** Vertices and triangles of an OBJ file that has only such faces. */
function readObj(path) {
  const positions = [];
  const indices = [];
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    const [kind, ...rest] = line.trim().split(/\s+/);
    if (kind === 'v') positions.push(...rest.slice(0, 3).map(Number));
    if (kind === 'f') indices.push(...rest.map((corner) => Number(corner.split('/')[0]) - 1));
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

function objOf(positions, indices) {
  const lines = [];
  for (let i = 0; i < positions.length; i += 3)
    lines.push(`v ${positions.slice(i, i + 3).join(' ')}`);
  for (let i = 0; i < indices.length; i += 3)
    lines.push(`f ${Array.from(indices.slice(i, i + 3), (v) => v + 1).join(' ')}`);
  return `${lines.join('\n')}\n`;
}

function run(args) {
  const { status, error } = spawnSync(program, args, { stdio: 'inherit' });
  if (error) throw error;
  if (status !== 0) throw new Error(`${program} ended with status ${status}`);
}

if (shared === null) {
  console.log('simplify: skipped, the models are missing');
  process.exit(0);
}
run(sizes.map(String));
await MeshoptSimplifier.ready;
const scratch = mkdtempSync(join(tmpdir(), 'foldwright-simplify-'));
const models = ['models/organic', 'models/full'].flatMap((folder) =>
  readdirSync(join(shared, folder)).map((name) => join(shared, folder, name)),
);
for (const path of models.filter((name) => /_5000\.obj$|models.full.*\.obj$/.test(name)).sort()) {
  const { positions, indices } = readObj(path);
  for (const faces of sizes) {
    const start = process.cpuUsage();
    const [simple] = MeshoptSimplifier.simplify(indices, positions, 3, 3 * faces, 1);
    const seconds = process.cpuUsage(start).user / 1e6;
    const made = join(scratch, 'simple.obj');
    writeFileSync(made, objOf(positions, simple));
    const title = `${path.replace(/.*\/|\.obj$/g, '')} ${faces}`;
    run(['--measure', path, made, title, 'meshoptimizer', String(seconds)]);
  }
}
rmSync(scratch, { recursive: true });
