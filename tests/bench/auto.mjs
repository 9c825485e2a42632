// Sets `auto` against every number of parts from 1 to 8, at the size that just fits: pieces and sheets of each model, and
// whether `auto` keeps its bound of at most twice the fewest pieces, on no more sheets than that number of parts.
// Takes folders or files below the shared ones as arguments; without any all that the bound is promised for. A model on
// each core, with one worker each: results do not depend on that. Ends with a status other than 0 if a run failed or the
// bound is not kept.
import { execFile } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { runnerImport } from 'vite';

const { module } = await runnerImport(fileURLToPath(new URL('../web/command.ts', import.meta.url)));
const { isBuilt, sharedFolder } = module;
const command = fileURLToPath(new URL('../../dist/cli/foldwright.js', import.meta.url));
const numbers = [1, 2, 3, 4, 5, 6, 7, 8];
const usual = ['cases', 'models/academic', 'models/lowpoly', 'models/organic'];
const models = /\.(obj|off|ply|stl)$/;

function filesBelow(path) {
  if (!statSync(path).isDirectory()) return models.test(path) ? [path] : [];
  return readdirSync(path)
    .sort()
    .flatMap((name) => filesBelow(join(path, name)));
}

const scratch = mkdtempSync(join(tmpdir(), 'foldwright-auto-'));

let reports = 0;

/** What the command comes to; null for a file that it refuses. */
async function outcome(path, parts) {
  const report = join(scratch, `${++reports}.json`);
  const options = ['--parts', String(parts), '--workers', '1', '--report', report, '--quiet'];
  try {
    await promisify(execFile)(process.execPath, [command, path, ...options], {
      timeout: 1_800_000,
    });
  } catch (error) {
    if (error.code === 3) return null;
    throw error;
  }
  const { pieces, sheets } = JSON.parse(readFileSync(report, 'utf8'));
  return { parts, pieces: pieces.length, sheets };
}

function printRow(name, auto, best, verdict) {
  console.log(`${name.padEnd(48)}${auto.padStart(14)}${best.padStart(22)}  ${verdict}`.trimEnd());
}

const isBetter = (a, b) => a.pieces < b.pieces || (a.pieces === b.pieces && a.sheets < b.sheets);

/** The number of parts with the fewest pieces; among those, with the fewest sheets. */
async function fewestPieces(path) {
  let best = await outcome(path, 1);
  for (const parts of numbers.slice(1)) {
    // Nothing is less than one piece, which lies on one sheet.
    if (best.pieces === 1) break;
    const other = await outcome(path, parts);
    if (isBetter(other, best)) best = other;
  }
  return best;
}

/** Whether `auto` breaks its bound for a model. */
async function breaksBound(path, name) {
  const auto = await outcome(path, 'auto');
  if (auto === null) return false;
  const best = await fewestPieces(path);
  const broken = auto.pieces > 2 * best.pieces || auto.sheets > best.sheets;
  const told = ({ pieces, sheets }) => `${pieces} on ${sheets}`;
  printRow(name, told(auto), `${told(best)} (${best.parts})`, broken ? 'BROKEN' : '');
  return broken;
}

const shared = sharedFolder();
if (!isBuilt || shared === null) {
  console.log(isBuilt ? 'auto: skipped, the models are missing' : 'auto: skipped, not built');
  process.exit(isBuilt ? 0 : 1);
}
const chosen = process.argv.length > 2 ? process.argv.slice(2) : usual;
printRow('model', 'auto', 'fewest (of parts)', '');
const waiting = chosen.flatMap((name) => filesBelow(join(shared, name)));
const count = waiting.length;
let broken = 0;
await Promise.all(
  Array.from({ length: availableParallelism() }, async () => {
    for (let path = waiting.shift(); path !== undefined; path = waiting.shift()) {
      if (await breaksBound(path, relative(shared, path))) broken += 1;
    }
  }),
);
rmSync(scratch, { recursive: true });
console.log(`${count} models, ${broken} beyond the bound`);
process.exit(broken > 0 ? 1 : 0);
