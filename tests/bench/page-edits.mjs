// Edits of a document in Chromium, through the package: milliseconds from the call to the new result, and the tasks that
// keep the page's own thread for more than 50 ms meanwhile. Takes models as arguments; without any one of 1000 faces, in
// 8 parts. What it takes to show the result is the studio's: see page.mjs.
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { serve } from '../../scripts/serve.mjs';

const load = async (name) => {
  const path = fileURLToPath(new URL(`../../${name}`, import.meta.url));
  return (await runnerImport(path)).module;
};
const { isBuilt, sharedFolder } = await load('tests/web/command.ts');
const { StudioPage } = await load('tests/e2e/studio-page.ts');

const parts = 8;
const rounds = 5;

/** Ms that each edit may take. */
const targets = {
  name: 50,
  flap: 50,
  place: 50,
  style: 50,
  cut: 50,
  undo: 50,
  redo: 50,
  paper: 300,
};

function models() {
  if (process.argv.length > 2) return process.argv.slice(2);
  return [join(sharedFolder(), 'models', 'organic', 'spot_1000.obj')];
}

const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];

/** Edges of some nets, as the vertices of the model that edits name: folds, and cuts between two pieces. */
function edgesOf(foldText) {
  const frames = JSON.parse(foldText).file_frames;
  const model = frames.find(({ frame_classes: classes }) => classes.includes('foldedForm'));
  const nets = frames.filter((frame) => frame['foldwright:piece'] !== undefined);
  const found = { folds: [], seams: [] };
  const pieceOfCut = new Map();
  for (const net of nets) {
    const sources = net['faces_foldwright:source'];
    const cornerOf = new Map();
    net.faces_vertices.forEach((corners, face) => {
      const names = model.faces_vertices[sources[face]];
      corners.forEach((corner, i) => {
        const next = corners[(i + 1) % corners.length];
        cornerOf.set(`${corner} ${next}`, [names[i], names[(i + 1) % names.length]]);
      });
    });
    net.edges_vertices.forEach(([v, w], edge) => {
      const named = cornerOf.get(`${v} ${w}`) ?? cornerOf.get(`${w} ${v}`);
      if (!named) return;
      if ('MV'.includes(net.edges_assignment[edge])) found.folds.push(named);
      else if (net.edges_assignment[edge] === 'B') {
        const key = named.toSorted((a, b) => a - b).join(' ');
        const other = pieceOfCut.get(key);
        if (other !== undefined && other !== net['foldwright:piece']) found.seams.push(named);
        pieceOfCut.set(key, net['foldwright:piece']);
      }
    });
  }
  return found;
}

const spread = (list, round) => list[Math.floor(((round + 0.5) * list.length) / rounds)];

/** What is done in each round, one after the other: the name of the row, and the edit or a call without one. */
function stepsOf({ folds, seams }, round) {
  return [
    ['name', { kind: 'name', part: 1, text: `Head ${round}` }],
    ['flap', { kind: 'flap', edge: spread(seams, round), side: 'none' }],
    ['place', { kind: 'place', piece: 1, sheet: 2 + round, x_mm: 20, y_mm: 20, turn_deg: 0 }],
    ['unpin', { kind: 'unpin', piece: 1 }],
    ['style', { kind: 'print', options: { style: round % 2 === 0 ? 'pepakura' : 'blender' } }],
    ['paper', { kind: 'paper', options: { paper: round % 2 === 0 ? 'Letter' : 'A4' } }],
    ['cut', { kind: 'cut', edge: spread(folds, round) }],
    ['undo', null],
    ['redo', null],
    ['undo', null],
    ['join', { kind: 'join', edge: spread(seams, round), search: true }],
    ['undo', null],
    ['split', { kind: 'split', part: 1 + round, into: 2 }],
    ['merge', { kind: 'merge', parts: [1 + round, parts + 1] }],
    ['undo', null],
    ['undo', null],
  ];
}

/** In the page. */
async function begin({ address, name, text, count }) {
  const { open } = await import(address);
  const session = await open([{ name, bytes: new globalThis.TextEncoder().encode(text) }]);
  await session.run({ parts: count, height: 150 });
  globalThis.session = session;
  globalThis.longTasks = [];
  new globalThis.PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) globalThis.longTasks.push(duration);
  }).observe({ type: 'longtask' });
  const [fold] = await session.export('fold');
  return new globalThis.TextDecoder().decode(fold.bytes);
}

/** In the page: ms, whether it was done, and the longest task. */
async function timed([step, edit]) {
  const { session, longTasks } = globalThis;
  longTasks.length = 0;
  const start = performance.now();
  const applied = edit ? await session.apply(edit) : session[step]();
  await session.result();
  const ms = performance.now() - start;
  await new Promise((resolve) => globalThis.setTimeout(resolve, 30));
  return {
    ms,
    refused: applied?.ok === false ? applied.code : null,
    longest: Math.max(0, ...longTasks),
  };
}

async function measure({ page }, address, model) {
  const text = readFileSync(model, 'utf8');
  const name = basename(model);
  const edges = edgesOf(await page.evaluate(begin, { address, name, text, count: parts }));
  const rows = new Map();
  for (let round = 0; round < rounds; ++round) {
    for (const step of stepsOf(edges, round)) {
      const row = rows.get(step[0]) ?? { ms: [], longest: 0, refused: [] };
      rows.set(step[0], row);
      const { ms, refused, longest } = await page.evaluate(timed, step);
      if (refused) row.refused.push(refused);
      else row.ms.push(ms);
      row.longest = Math.max(row.longest, longest);
    }
  }
  return rows;
}

function printRow(name, values, verdict) {
  console.log(
    `${name.padEnd(10)}${values.map((v) => String(v).padStart(10)).join('')}  ${verdict}`.trimEnd(),
  );
}

function print(rows) {
  printRow('edit', ['done', 'median ms', 'worst ms', 'task ms'], '');
  for (const [name, { ms, longest, refused }] of rows) {
    const target = targets[name];
    const met = target === undefined || median(ms) <= target;
    const verdict = target === undefined ? '' : `<= ${target} ms: ${met ? 'met' : 'MISSED'}`;
    const figures = ms.length > 0 ? [median(ms), Math.max(...ms)] : [NaN, NaN];
    const values = [ms.length, ...[...figures, longest].map((value) => value.toFixed(0))];
    printRow(name, values, [verdict, ...new Set(refused)].join(' '));
  }
}

const shared = sharedFolder();
if (!isBuilt || shared === null) {
  console.log(
    isBuilt ? 'page edits: skipped, the models are missing' : 'page edits: skipped, not built',
  );
  process.exit(isBuilt ? 0 : 1);
}
const server = await serve(fileURLToPath(new URL('../../dist', import.meta.url)));
for (const model of models()) {
  console.log(`\n${basename(model)} in ${parts} parts`);
  const studio = await StudioPage.open(`${server.address}studio/`);
  print(await measure(studio, `${server.address}package/foldwright.js`, model));
  await studio.close();
}
server.close();
