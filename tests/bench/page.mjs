// The studio in Chromium with models of life: prints how long a dropped file takes to become nets, the tasks that keep
// the page's own thread for more than 50 ms meanwhile, how soon a cancel is answered in every stage, how long a frame of
// the folding takes, and how often a run that tells of generation after generation is drawn.
import { readFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { serve } from '../../scripts/serve.mjs';

const path = (name) => fileURLToPath(new URL(`../../${name}`, import.meta.url));
const load = async (name) => (await runnerImport(path(name))).module;
const { isBuilt, sharedFolder } = await load('tests/web/command.ts');
const { cancelAt, drawingsPerSecond, stageWords, timeFolding, timeRun } =
  await load('tests/e2e/page-clock.ts');
const { StudioPage } = await load('tests/e2e/studio-page.ts');

/** Faces, and runs of which the shortest counts. */
const sizes = [
  { faces: 1000, rounds: 3 },
  { faces: 5000, rounds: 1 },
];
const parts = 10;
const mostFaces = Math.max(...sizes.map(({ faces }) => faces));
/** Ms after which the studio has loaded all that it loads ahead of a run. */
const preparation = 3000;

const netsTarget = { faces: 1000, seconds: 3 };
const cancelTarget = 200;
const drawingTarget = 10;
const frameTarget = { faces: 1000, ms: 50 };

/** The page draws itself, so that its frames wait for the pictures. */
const withoutWorkers = 'delete HTMLCanvasElement.prototype.transferControlToOffscreen;';

const verdict = (met) => (met ? 'met' : 'MISSED');

/** The shortest of several runs, each in a browser of its own, and the worst of their long tasks. */
async function measureRuns(address, model, rounds) {
  let nets = Infinity;
  const longTasks = [];
  for (let round = 0; round < rounds; ++round) {
    await withStudio(address, async (studio) => {
      const times = await timeRun(studio, model.name, model.content);
      nets = Math.min(nets, times.nets / 1000);
      longTasks.push(...times.longTasks);
    });
  }
  return { nets, longTasks, rounds };
}

async function withStudio(address, work, options = {}) {
  const studio = await StudioPage.open(address, { reducedMotion: 'no-preference', ...options });
  try {
    await studio.page.fill('#parts', String(parts));
    // Whoever asks for a number of triangles is not held at the check of large models.
    await studio.page.fill('#faces', String(mostFaces));
    await studio.page.waitForTimeout(preparation);
    await work(studio);
  } finally {
    await studio.close();
  }
}

/** Ms until a cancel is answered, by stage. Each run is the first of its page, so that nets that were found are shown. */
async function measureCancels(address, model) {
  const answers = [];
  for (const stage of stageWords) {
    await withStudio(address, async (studio) => {
      const latency = cancelAt(studio, stage);
      await studio.choose(model.name, model.content);
      answers.push([stage, await latency]);
    });
  }
  return answers;
}

/** The sorted ms between frames while the folding is played. */
async function measureFolding(address, model) {
  let frames = [];
  const work = async (studio) => {
    await studio.choose(model.name, model.content);
    await studio.resultOf(model.name.replace('.obj', ''));
    // The first frame of all makes everything ready; it is played twice.
    await timeFolding(studio);
    frames = await timeFolding(studio);
  };
  await withStudio(address, work, { script: withoutWorkers });
  return frames.sort((a, b) => a - b);
}

/** How often a second the fitness is drawn while the genetic search goes on. */
async function measureDrawing(address, model) {
  let rate = 0;
  const work = async (studio) => {
    await studio.page.selectOption('#solver', 'genetic');
    await studio.choose(model.name, model.content);
    await studio.page.locator('#how summary').click();
    await studio.page.locator('#chart .curve--now').waitFor({ timeout: 60_000 });
    rate = await drawingsPerSecond(studio);
    await studio.page.locator('#cancel').click();
  };
  await withStudio(address, work);
  return rate;
}

function printDrawing(faces, rate) {
  // A drawing may fall on either end of the time that is looked at.
  const met = rate > 0 && rate <= drawingTarget + 0.5;
  console.log(
    `page: ${faces} faces: generations are drawn ${rate.toFixed(1)} times a second ` +
      `(<= ${drawingTarget}: ${verdict(met)})`,
  );
}

function printFolding(faces, frames) {
  const [median, most] = [0.5, 0.95].map((share) => frames[Math.floor(share * frames.length)]);
  const { ms } = frameTarget;
  const aim = faces === frameTarget.faces ? ` (<= ${ms} ms: ${verdict(median <= ms)})` : '';
  console.log(
    `page: ${faces} faces: a frame of the folding takes ${median.toFixed(0)} ms${aim}, ` +
      `19 of 20 at most ${most.toFixed(0)} ms`,
  );
}

function print(faces, { nets, longTasks, rounds }, cancels) {
  const aim =
    faces === netsTarget.faces
      ? ` (<= ${netsTarget.seconds} s on two free cores: ${verdict(nets <= netsTarget.seconds)})`
      : '';
  console.log(`page: ${faces} faces, ${parts} parts: nets after ${nets.toFixed(2)} s${aim}`);
  const longest = Math.max(0, ...longTasks).toFixed(0);
  console.log(
    `page: ${faces} faces: ${longTasks.length} tasks over 50 ms in ${rounds} run(s), the longest ${longest} ms ` +
      `(none: ${verdict(longTasks.length === 0)})`,
  );
  const words = cancels.map(([stage, latency]) => `${stage} ${latency.toFixed(0)} ms`).join(', ');
  const answered = cancels.every(([, latency]) => latency <= cancelTarget);
  console.log(`page: ${faces} faces: cancel answered while ${words}`);
  console.log(`page: ${faces} faces: cancel answered in ${cancelTarget} ms: ${verdict(answered)}`);
}

const shared = sharedFolder();
if (!isBuilt || shared === null) {
  console.log(isBuilt ? 'page: skipped, its models are missing' : 'page: skipped, not built');
  process.exit(isBuilt ? 0 : 1);
}
const server = await serve(path('dist'));
for (const { faces, rounds } of sizes) {
  const name = `cat_${faces}.obj`;
  const content = readFileSync(join(shared, 'models', 'organic', name), 'utf8');
  const model = { name, content };
  const address = `${server.address}studio/`;
  console.log(`page: ${faces} faces: load of the machine ${loadavg()[0].toFixed(1)}`);
  print(faces, await measureRuns(address, model, rounds), await measureCancels(address, model));
  printFolding(faces, await measureFolding(address, model));
  printDrawing(faces, await measureDrawing(address, model));
}
server.close();
