// Prints every model of the shared folder that has colours or pictures, takes the images of its sheets back onto the
// model and compares them with what another program (three.js in Chromium) sees there; takes some minutes. With a word,
// only the models that have it in their paths. Ends with a status other than 0 if a print differs from its model.
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const load = async (name) => {
  const path = fileURLToPath(new URL(`../${name}`, import.meta.url));
  return (await runnerImport(path)).module;
};
const { isBuilt, sharedFolder } = await load('web/command.ts');
const { texturedCases } = await load('web/textured-cases.ts');
const { checkTexture } = await load('web/texture-check.ts');
const { lookedSurface } = await load('web/looked-surface.ts');
const { TrueSurfaces } = await load('e2e/true-surfaces.ts');
const { startChromium } = await load('e2e/chromium.ts');

const shared = sharedFolder();
if (!isBuilt || shared === null) {
  console.log(isBuilt ? 'texture: skipped, the models are missing' : 'texture: skipped, not built');
  process.exit(isBuilt ? 0 : 1);
}
const { open, startPool } = await import('../../dist/cli/index.js');

const dpi = 150;
/** Nothing turns the model, so that it can be laid over what the other program reads. */
const options = { runs: 2, up: 'y', folding: 'off', compact: 'off', dpi, texture: 'on' };
// What differs more is looked at; single dots at the borders of colours do.
const most = { mean: 4, off: 3, bare: 0, bareBleed: 0.5, bareFlaps: 0.5, distance: 0.05 };
/** Faces beside their surface show what is nearest: borders of colours move as far as these lie apart. */
const mostBeside = { off: 5 };
const columns = ['mean', 'worst', 'off', 'bare', 'bareBleed', 'bareFlaps', 'bleed', 'distance'];

function printRow(name, cells, verdict = '') {
  const numbers = cells.map((cell) => cell.padStart(11)).join('');
  console.log(`${name.padEnd(64)}${numbers}  ${verdict}`.trimEnd());
}

async function figuresOf({ files, faces, isReadElsewhere }, pool, surfaces) {
  const session = await open(files, { pool });
  await session.run({ ...options, ...(faces && { faces }) });
  const result = await session.result();
  const sheets = (await session.export('svg')).map(({ bytes }) => Buffer.from(bytes).toString());
  session.close();
  if (!result.looks) return null;
  const surface = isReadElsewhere ? await surfaces.of(files) : lookedSurface(result);
  return checkTexture(result, sheets, surface);
}

function faultsOf(figures, isBeside) {
  return Object.entries(most).flatMap(([name, limit]) => {
    if (isBeside && name === 'distance') return [];
    return figures[name] <= (isBeside ? (mostBeside[name] ?? limit) : limit) ? [] : [name];
  });
}

const browser = await startChromium();
const surfaces = await TrueSurfaces.start(browser);
const pool = startPool();
printRow(`model, at ${dpi} dots to the inch`, columns);
let faults = 0;
let count = 0;
for (const each of texturedCases(shared)) {
  if (!each.name.includes(process.argv[2] ?? '')) continue;
  try {
    const figures = await figuresOf(each, pool, surfaces);
    if (!figures) {
      console.log(`${each.name.padEnd(64)} no colours`);
      continue;
    }
    const wrong = faultsOf(figures, each.isBeside);
    ++count;
    if (wrong.length > 0) ++faults;
    const cells = columns.map((column) => figures[column].toFixed(3));
    printRow(each.name, cells, wrong.join(' '));
  } catch (error) {
    ++faults;
    console.log(
      `${each.name.padEnd(64)} ${error instanceof Error ? error.message : String(error)}`,
    );
  }
}
pool.close();
await browser.close();
console.log(`${count} models in colours, ${faults} that differ`);
process.exit(faults > 0 ? 1 : 0);
