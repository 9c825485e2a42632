// Runs the built command line over the whole corpus and judges every net; slow. Prints a table of what came out, and
// ends with a status other than 0 if any run failed or any net cannot be cut out and folded.
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const load = async (name) => {
  const path = fileURLToPath(new URL(`../web/${name}`, import.meta.url));
  return (await runnerImport(path)).module;
};
const { checkedRun } = await load('checked-run.ts');
const { corpusCases } = await load('corpus.ts');
const { isBuilt, sharedFolder } = await load('command.ts');

const limit = 600_000;
const columns = [
  ['model', 28],
  ['faces', 6],
  ['asked', 6],
  ['parts', 6],
  ['pieces', 7],
  ['sheets', 7],
  ['violations', 11],
  ['seconds', 9],
];

function printRow(values) {
  const cell = (value, i) =>
    i === 0 ? String(value).padEnd(columns[i][1]) : String(value).padStart(columns[i][1]);
  console.log(values.map(cell).join(''));
}

/** What is wrong with a run, one sentence each. */
function faultsOf({ ended, report, violations }) {
  if (report) return violations;
  return [`ended with status ${ended.status}: ${ended.stderr.trim()}`];
}

async function measure({ model, path, parts }) {
  const start = performance.now();
  const run = await checkedRun(path, ['--parts', parts], limit);
  const seconds = (run.report?.seconds.total ?? (performance.now() - start) / 1000).toFixed(2);
  const faults = faultsOf(run);
  const { report } = run;
  printRow([
    model,
    report?.model.faces ?? '-',
    parts,
    report?.parts ?? '-',
    report?.pieces.length ?? '-',
    report?.sheets ?? '-',
    faults.length,
    seconds,
  ]);
  for (const fault of faults.slice(0, 5)) console.log(`    ${fault}`);
  return { parts, pieces: report?.pieces.length, faults: faults.length };
}

/** Of the runs that asked for so many parts, how many came out as so many pieces. */
function printShare(rows, parts, sentence) {
  const asked = rows.filter((row) => row.parts === String(parts));
  const met = asked.filter((row) => row.pieces === parts).length;
  console.log(
    `${sentence}: ${met} of ${asked.length} (${((100 * met) / asked.length).toFixed(1)} %)`,
  );
}

const shared = sharedFolder();
if (!isBuilt || shared === null) {
  console.log(isBuilt ? 'corpus: skipped, its models are missing' : 'corpus: skipped, not built');
  process.exit(isBuilt ? 0 : 1);
}

printRow(columns.map(([name]) => name));
const rows = [];
for (const each of corpusCases(shared)) rows.push(await measure(each));
printShare(rows, 8, 'pieces == 8 where 8 parts were asked for');
printShare(rows, 1, 'one piece where 1 part was asked for');
process.exit(rows.some(({ faults }) => faults > 0) ? 1 : 0);
