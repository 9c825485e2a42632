// Sets `auto` against every number of parts from 1 to 8, at the size that just fits: pieces and sheets of each model, and
// whether `auto` keeps its bound of at most twice the fewest pieces, on no more sheets than that number of parts.
// Takes folders or files below the shared ones as arguments; without any all that the bound is promised for, which takes an
// hour. Ends with a status other than 0 if a run failed or the bound is not kept.
import { execFile } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
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

/** What the command comes to; null for a file that it refuses. */
async function outcome(path, parts) {
  const report = join(scratch, `${parts}.json`);
  const args = [command, path, '--parts', String(parts), '--report', report, '--quiet'];
  try {
    await promisify(execFile)(process.execPath, args, { timeout: 600_000 });
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

/** Whether `auto` breaks its bound for a model. */
async function breaksBound(path, name) {
  const auto = await outcome(path, 'auto');
  if (auto === null) return false;
  const others = [];
  for (const parts of numbers) others.push(await outcome(path, parts));
  const best = others.reduce((a, b) =>
    b.pieces < a.pieces || (b.pieces === a.pieces && b.sheets < a.sheets) ? b : a,
  );
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
let broken = 0;
let count = 0;
for (const path of chosen.flatMap((name) => filesBelow(join(shared, name)))) {
  count += 1;
  if (await breaksBound(path, relative(shared, path))) broken += 1;
}
rmSync(scratch, { recursive: true });
console.log(`${count} models, ${broken} beyond the bound`);
process.exit(broken > 0 ? 1 : 0);
