// How time and memory grow with the number of faces, in Chromium with two workers beside the native engine on one thread:
// one detailed model, simplified to each size beforehand, from file to nets. Prints the seconds of every stage, what
// the memory of all the engine's workers came to at most, and how soon a cancel is answered with the largest model.
// `growth.mjs [MOST_FACES] [PARTS] [FOLDING]`
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { serve } from '../../scripts/serve.mjs';

const path = (name) => fileURLToPath(new URL(`../../${name}`, import.meta.url));
const load = async (name) => (await runnerImport(path(name))).module;
const { isBuilt, sharedFolder } = await load('tests/web/command.ts');
const { cancelAt, stageWords } = await load('tests/e2e/page-clock.ts');
const { StudioPage } = await load('tests/e2e/studio-page.ts');

const [most = '70000', parts = '12', folding = 'prefer'] = process.argv.slice(2);
const stages = ['read', 'learn', 'cluster', 'search', 'compact', 'paper', 'total'];
/** Seconds from file to nets and MB, on two free cores. */
const targets = { 5000: { seconds: 5 }, 20000: { seconds: 20, megabytes: 1000 } };
const cancelTarget = 100;
/** Ms that a run may take. */
const patience = 1_800_000;
/** Ms after which the studio has loaded all that it loads ahead of a run. */
const preparation = 3000;

/** In the page: remembers the seconds of the stages and the number of pieces of the last job. */
const listenToJobs = `{
  const Plain = Worker;
  globalThis.Worker = class extends Plain {
    constructor(...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        for (const event of data?.events ?? []) {
          if (event.type !== 'done') continue;
          globalThis.lastRun = { seconds: event.seconds, pieces: event.result.pieces.length };
        }
      });
    }
  };
}`;

/** Before a worker's own script: keeps hold of the memory of the WebAssembly module that it loads. */
const holdMemory = `for (const name of ['instantiate', 'instantiateStreaming']) {
  const plain = WebAssembly[name];
  WebAssembly[name] = async (...args) => {
    const loaded = await plain.apply(WebAssembly, args);
    const { exports } = loaded.instance ?? loaded;
    globalThis.heldMemory = Object.values(exports).find((e) => e instanceof WebAssembly.Memory);
    return loaded;
  };
}\n`;

/** MB of each worker that has loaded the engine; its memory never shrinks. */
async function megabytesOfWorkers(page) {
  const heaps = page
    .workers()
    .map((worker) => worker.evaluate('globalThis.heldMemory?.buffer.byteLength ?? 0'));
  return (await Promise.all(heaps)).filter((bytes) => bytes > 0).map((bytes) => bytes / 2 ** 20);
}

async function withStudio(address, work) {
  const studio = await StudioPage.open(address, {
    script: listenToJobs,
    workerScript: holdMemory,
  });
  try {
    const { page } = studio;
    if (parts !== '0') await page.fill('#parts', parts);
    await page.locator('#more').evaluate((details) => (details.open = true));
    await page.selectOption('#folding-mode', folding);
    await page.waitForTimeout(preparation);
    await work(studio);
  } finally {
    await studio.close();
  }
}

/** Follows a run from the file to the nets on the page. */
async function measure(address, model) {
  let row = null;
  await withStudio(address, async (studio) => {
    const { page } = studio;
    const start = performance.now();
    await studio.choose(model.name, model.content);
    await page.locator('#result:not([hidden])').waitFor({ timeout: patience });
    const wall = (performance.now() - start) / 1000;
    const { seconds, pieces } = await page.evaluate('lastRun');
    row = {
      pieces,
      seconds: { ...seconds, total: wall },
      megabytes: await megabytesOfWorkers(page),
    };
  });
  return row;
}

/** Ms until a cancel is answered, by stage. */
async function measureCancels(address, model) {
  for (const stage of stageWords) {
    await withStudio(address, async (studio) => {
      const latency = cancelAt(studio, stage);
      await studio.choose(model.name, model.content);
      const ms = await latency;
      const verdict = ms <= cancelTarget ? 'met' : 'MISSED';
      console.log(
        `growth: ${model.faces} faces: cancel while ${stage}: ${ms.toFixed(0)} ms: ${verdict}`,
      );
    });
  }
}

function printRow(faces, where, pieces, seconds, megabytes, rest = '') {
  const numbers = [pieces, ...seconds, megabytes].map((cell) => String(cell).padStart(10)).join('');
  console.log(`${String(faces).padStart(7)}  ${where.padEnd(9)}${numbers}  ${rest}`.trimEnd());
}

/** Nets are there when the search is done; what follows makes them better and prints them. */
function verdictOn(faces, { seconds, megabytes }) {
  const target = targets[faces];
  if (!target) return '';
  const sum = megabytes.reduce((a, b) => a + b, 0);
  const { read, learn, cluster, search } = seconds;
  const nets = read + learn + cluster + search;
  const met = nets <= target.seconds && sum <= (target.megabytes ?? Infinity);
  const memory = target.megabytes ? `, ${target.megabytes} MB` : '';
  return `nets in ${nets.toFixed(1)} s (<= ${target.seconds})${memory}: ${met ? 'met' : 'MISSED'}`;
}

/** The native engine's rows, by faces; leaves the models in `folder`. */
function measureNative(folder) {
  const args = ['--most', most, '--parts', parts, '--keep', folder];
  if (folding === 'off') args.push('--no-folding');
  const options = { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] };
  const { stdout, status } = spawnSync(path('build/release/bench_growth'), args, options);
  if (status !== 0) throw new Error(`bench_growth ended with status ${status}`);
  const lines = stdout.trim().split('\n').slice(1);
  return new Map(
    lines
      .map((line) => line.trim().split(/\s+/))
      .map((cells) => [Number(cells[0]), cells.slice(1)]),
  );
}

async function run(folder) {
  const native = measureNative(folder);
  const server = await serve(path('dist'));
  const address = `${server.address}studio/`;
  const faces = readdirSync(folder).map((file) => Number.parseInt(file, 10));
  printRow(
    'faces',
    'where',
    'pieces',
    stages.map((stage) => `${stage} s`),
    'MB',
  );
  let model;
  for (const size of faces.sort((a, b) => a - b)) {
    model = {
      faces: size,
      name: `${size}.off`,
      content: readFileSync(join(folder, `${size}.off`)),
    };
    const [pieces, , ...numbers] = native.get(size) ?? [];
    printRow(size, 'native', pieces, numbers.slice(0, -1), numbers.at(-1));
    const row = await measure(address, model);
    const memory = row.megabytes.map((mb) => mb.toFixed(0)).join('+');
    const seconds = stages.map((stage) => row.seconds[stage].toFixed(2));
    printRow(size, 'chromium', row.pieces, seconds, memory, verdictOn(size, row));
  }
  await measureCancels(address, model);
  server.close();
}

if (!isBuilt || sharedFolder() === null) {
  console.log(isBuilt ? 'growth: skipped, its model is missing' : 'growth: skipped, not built');
  process.exit(isBuilt ? 0 : 1);
}
console.log(`growth: load of the machine ${loadavg()[0].toFixed(1)}`);
const folder = mkdtempSync(join(tmpdir(), 'foldwright-growth-'));
try {
  await run(folder);
} finally {
  rmSync(folder, { recursive: true });
}
