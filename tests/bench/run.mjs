// Runs the engine's benchmarks, native and WASM in turn in one run, and prints them side by side with what is aimed at.
// With --full also both solvers on small models, which takes minutes, the paper's studies, parts and paper over the
// organic models, growth in Chromium, and the whole corpus, as nets, on sheets and in colours. Takes the builds as they are: `npm run bench` makes them first.
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const sizes = [300, 574, 1000, 2000, 3000, 5000];
// Both are measured again and again in turn, so that whatever else the machine does slows both alike.
const rounds = 3;

const targets = [
  { faces: 1000, stage: 'learn', seconds: 1 },
  { faces: 1000, stage: 'search-whole', seconds: 0.1 },
];
const ratioTarget = 1.5;
const studies = ['foldability', 'craft', 'runs', 'heuristics', 'pieces', 'benchmark', 'gallery'];

function run(program, args, stdio = ['ignore', 'pipe', 'inherit']) {
  const { status, stdout, error } = spawnSync(program, args, {
    cwd: root,
    encoding: 'utf8',
    stdio,
  });
  if (error) throw error;
  if (status !== 0) throw new Error(`${program} ${args.join(' ')} ended with status ${status}`);
  return stdout;
}

const engines = {
  native: (faces) => run('build/release/bench_stages', [faces]),
  wasm: (faces) => run(process.execPath, ['build/wasm/bench_stages.cjs', faces]),
};

function median(values) {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
}

/** Seconds of every stage at one size, by engine: the medians over all rounds. */
function measure(faces) {
  const rows = new Map();
  for (let round = 0; round < rounds; round++) {
    for (const [engine, program] of Object.entries(engines)) {
      for (const line of program(String(faces)).trim().split('\n')) {
        const { stage, seconds } = JSON.parse(line);
        const row = rows.get(stage) ?? { native: [], wasm: [] };
        row[engine].push(seconds);
        rows.set(stage, row);
      }
    }
  }
  return [...rows].map(([stage, { native, wasm }]) => ({
    faces,
    stage,
    native: median(native),
    wasm: median(wasm),
  }));
}

function verdict({ faces, stage, native, wasm }) {
  const target = targets.find((aim) => aim.faces === faces && aim.stage === stage);
  const aims = [];
  if (target) aims.push([`native <= ${target.seconds} s`, native <= target.seconds]);
  // Under some milliseconds the clock and the first calls decide.
  if (native >= 0.02) aims.push([`ratio <= ${ratioTarget}`, wasm / native <= ratioTarget]);
  return aims.map(([aim, met]) => `${aim}: ${met ? 'met' : 'MISSED'}`).join(', ');
}

function printRow(faces, stage, native, wasm, ratio, verdicts) {
  const numbers = [native, wasm, ratio].map((cell) => cell.padStart(10)).join('');
  console.log(`${faces.padStart(6)}  ${stage.padEnd(16)}${numbers}  ${verdicts}`.trimEnd());
}

printRow('faces', 'stage', 'native s', 'wasm s', 'ratio', '');
for (const faces of sizes) {
  for (const row of measure(faces)) {
    const { stage, native, wasm } = row;
    const ratio = (wasm / native).toFixed(2);
    printRow(String(faces), stage, native.toFixed(3), wasm.toFixed(3), ratio, verdict(row));
  }
}
console.log(`\n${run('build/release/bench_heuristics', [])}`);
run(process.execPath, ['tests/bench/pool.mjs'], 'inherit');
run(process.execPath, ['tests/bench/page.mjs'], 'inherit');
if (process.argv.includes('--full')) {
  run('build/release/bench_solvers', ['--full'], 'inherit');
  run('build/release/bench_segmentation', [], 'inherit');
  for (const study of studies)
    run(`build/release/bench_study_${study}`, ['build/studies'], 'inherit');
  run('build/release/bench_pieces', [], 'inherit');
  run('build/release/bench_paper', [], 'inherit');
  run('build/release/bench_paper', ['folding=off'], 'inherit');
  run(process.execPath, ['tests/bench/growth.mjs', '20000'], 'inherit');
  run(process.execPath, ['tests/bench/edits.mjs'], 'inherit');
  run(process.execPath, ['tests/bench/page-edits.mjs'], 'inherit');
  run('build/release/bench_edit_stages', [], 'inherit');
  run(process.execPath, ['tests/bench/corpus.mjs'], 'inherit');
  run(process.execPath, ['tests/bench/sheets.mjs'], 'inherit');
  run(process.execPath, ['tests/bench/damaged.mjs'], 'inherit');
  run(process.execPath, ['tests/bench/texture.mjs'], 'inherit');
  run(process.execPath, ['tests/bench/auto.mjs'], 'inherit');
}
