// Prints the models that people would build on A4, 150 mm high in 8 parts, and judges what was written, SVG and PDF;
// takes minutes. Ends with a status other than 0 if any run failed or any sheet cannot be cut out, folded and glued.
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const load = async (name) => {
  const path = fileURLToPath(new URL(`../web/${name}`, import.meta.url));
  return (await runnerImport(path)).module;
};
const { faultsOf, printedRun } = await load('printed-run.ts');
const { sheetCases } = await load('corpus.ts');
const { isBuilt, sharedFolder } = await load('command.ts');

const limit = 600_000;
const margin = 10;
const options = ['--parts', '8', '--height', '150', '--margin', String(margin)];
const widths = [28, 6, 7, 7, 6, 8, 6, 9, 9, 11];

function printRow(values) {
  const cell = (value, i) => String(value)[i === 0 ? 'padEnd' : 'padStart'](widths[i]);
  console.log(values.map(cell).join(''));
}

/** Prints what one model came to; returns how much is wrong with it. */
async function judge({ model, path }) {
  try {
    const run = await printedRun(path, options, limit);
    const { report } = run;
    const faults = faultsOf(run, margin);
    const flaps = report.flaps.full + report.flaps.shrunk;
    const share = (part, all) => (all === 0 ? '-' : `${((100 * part) / all).toFixed(1)} %`);
    printRow([
      model,
      report.model.faces,
      report.pieces.length,
      report.sheets,
      flaps,
      share(flaps, report.flaps.wanted),
      report.ids.printed,
      share(report.ids.printed, report.ids.printed + report.ids.skipped.length),
      report.seconds.total.toFixed(1),
      faults.length,
    ]);
    for (const fault of faults.slice(0, 5)) console.log(`    ${fault}`);
    return faults.length;
  } catch (error) {
    console.log(`${model} ${error instanceof Error ? error.message : String(error)}`);
    return 1;
  }
}

const shared = sharedFolder();
if (!isBuilt || shared === null) {
  console.log(isBuilt ? 'sheets: skipped, the models are missing' : 'sheets: skipped, not built');
  process.exit(isBuilt ? 0 : 1);
}

// With a word, only the models that have it in their names.
const cases = sheetCases(shared).filter(({ model }) => model.includes(process.argv[2] ?? ''));
printRow(['model', 'faces', 'pieces', 'sheets', 'flaps', '', 'ids', '', 'seconds', 'violations']);
let faults = 0;
for (const each of cases) faults += await judge(each);
console.log(`${cases.length} models, ${faults} violations`);
process.exit(faults > 0 ? 1 : 0);
