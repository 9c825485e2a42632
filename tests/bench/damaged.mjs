// Damages real files of all formats, as transport and storage do, and has each read and repaired: a model or a sentence
// must come of it within 10 s, and the next file must be read as ever. Takes how often each file is damaged, once by
// default, and the seed, 1 by default. Prints what came of them by format, and what took longest; ends with a status
// other than 0 if a file gave neither model nor sentence, or took longer.
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const load = async (name) => {
  const path = fileURLToPath(new URL(`../../${name}`, import.meta.url));
  return (await runnerImport(path)).module;
};
const { damaged, numbers } = await load('tests/web/damage.ts');
const { modelsBelow } = await load('tests/web/corpus.ts');
const { isBuilt, sharedFolder } = await load('tests/web/command.ts');
const { readModelFiles } = await load('web/cli/read-model-files.ts');

/** What people wait for, in ms. */
const patience = 10_000;

const shared = sharedFolder();
if (!isBuilt || shared === null) {
  console.log(isBuilt ? 'damaged: skipped, the models are missing' : 'damaged: skipped, not built');
  process.exit(isBuilt ? 0 : 1);
}
const { open } = await import('../../dist/cli/index.js');

/** What comes of files: a model, the code of a sentence, or a fault of ours. */
async function outcomeOf(files) {
  const begin = performance.now();
  const session = await open(files);
  try {
    const { model } = await session.inspect();
    const isModel = model.faces.length > 0;
    return { kind: isModel ? 'model' : 'fault', what: '', ms: performance.now() - begin };
  } catch (error) {
    const isSentence = typeof error.code === 'string' && error.code !== 'internal' && error.message;
    const what = isSentence ? error.code : String(error.stack ?? error);
    return { kind: isSentence ? 'sentence' : 'fault', what, ms: performance.now() - begin };
  } finally {
    await session.close();
  }
}

const [rounds, seed] = [Number(process.argv[2] ?? 1), Number(process.argv[3] ?? 1)];
const below = numbers(seed);
const rows = new Map();
const slow = [];
let faults = 0;
for (const path of ['models', 'nasty', 'cases'].flatMap((folder) => modelsBelow(shared, folder))) {
  let files;
  try {
    files = readModelFiles(join(shared, path));
  } catch {
    continue; // what the command does not take as a model
  }
  for (let round = 0; round < rounds; round++) {
    const [first, ...others] = files;
    const broken = { name: first.name, bytes: damaged(first.bytes, below) };
    const outcome = await outcomeOf([broken, ...others]);
    const format = extname(path).toLowerCase();
    const row = rows.get(format) ?? { model: 0, sentence: 0, fault: 0, longest: 0 };
    row[outcome.kind] += 1;
    row.longest = Math.max(row.longest, outcome.ms);
    rows.set(format, row);
    slow.push({ path, ms: outcome.ms });
    if (outcome.kind === 'fault' || outcome.ms > patience) {
      faults += 1;
      console.log(
        `${path}, damaged for the ${round + 1}. time: ${outcome.ms.toFixed(0)} ms ${outcome.what}`,
      );
    }
  }
}

const printRow = (format, cells) => {
  console.log(format.padEnd(10) + cells.map((cell) => String(cell).padStart(12)).join(''));
};
printRow('format', ['models', 'sentences', 'faults', 'longest ms']);
for (const [format, { model, sentence, fault, longest }] of [...rows].sort()) {
  printRow(format, [model, sentence, fault, longest.toFixed(0)]);
}
for (const { path, ms } of slow.sort((a, b) => b.ms - a.ms).slice(0, 5)) {
  console.log(`${ms.toFixed(0).padStart(7)} ms ${path}`);
}
console.log(`${slow.length} files, ${faults} faults`);
process.exitCode = faults > 0 ? 1 : 0;
