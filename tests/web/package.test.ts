/** The package as others get it: packed, installed into an empty project, and called from there. */
import { execFile } from 'node:child_process';
import { mkdir, readFile, rename, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { describe, expect, it } from 'vitest';
import { foldwright, inFolder, isBuilt } from './command.js';
import { objText, wavyRing } from './model-text.js';

const run = promisify(execFile);
const root = fileURLToPath(new URL('../..', import.meta.url));
const tsc = join(root, 'node_modules/typescript/bin/tsc');

/** Written as a stranger would, from the README. */
const program = `
import { readFile, writeFile } from 'node:fs/promises';
import { open, unfold, type DocumentEdit, type Options } from 'foldwright';

const bytes = await readFile('ring.obj');
const options: Options = { parts: 4, seed: 3, height: 80, flapSide: 'alternate' };
const unfolded = await unfold([{ name: 'ring.obj', bytes }], options);
const parts: number = unfolded.report.parts;
for (const file of await unfolded.export('fold')) await writeFile(file.name, file.bytes);
const [book] = await unfolded.export('pdf', { assembly: true });
const [sheets] = await unfolded.export('pdf');
const isLonger = book!.bytes.length > sheets!.bytes.length;

const session = await open([{ name: 'ring.obj', bytes }]);
await session.run(options);
const edit: DocumentEdit = { kind: 'split', part: 1, into: 2 };
const applied = await session.apply(edit);
const answer = applied.ok ? applied.changed.length : applied.code;
session.undo();
console.log(JSON.stringify({ parts, answer, isLonger, after: session.report.parts }));
session.close();
`;

const page = `
import { unfold, startPool } from 'foldwright';
import 'foldwright/studio';

const pool = startPool(2, { worker: 'https://example.com/worker.js' });
await unfold([], { paper: 'A3' }, { pool, onEvent: (event) => console.log(event.type) });
document.createElement('foldwright-studio').addEventListener('foldwright-event', ({ detail }) => {
  console.log(detail.type);
});
// @ts-expect-error there is no such paper option
await unfold([], { papier: 'A3' });
`;

const strict = {
  strict: true,
  exactOptionalPropertyTypes: true,
  noUncheckedIndexedAccess: true,
  skipLibCheck: false,
  target: 'ES2022',
  types: [],
};

async function compile(folder: string, name: string, options: object): Promise<void> {
  const config = { compilerOptions: { ...strict, ...options }, files: [name] };
  await writeFile(join(folder, 'tsconfig.json'), JSON.stringify(config));
  await run(process.execPath, [tsc, '-p', folder]).catch((error: { stdout: string }) => {
    throw new Error(error.stdout);
  });
}

/** Packs the built package and puts it where an installation would. */
async function install(folder: string): Promise<void> {
  const pack = ['pack', '--ignore-scripts', '--silent', '--pack-destination', folder];
  const { stdout } = await run('npm', pack, { cwd: root });
  await run('tar', ['-xzf', join(folder, stdout.trim()), '-C', folder]);
  await mkdir(join(folder, 'node_modules'));
  await rename(join(folder, 'package'), join(folder, 'node_modules/foldwright'));
}

describe.skipIf(!isBuilt)('the package', () => {
  it(
    'is typed, and gives under node what the command line gives',
    () =>
      inFolder(async (folder) => {
        await install(folder);
        await writeFile(join(folder, 'package.json'), '{ "type": "module" }');
        await writeFile(join(folder, 'ring.obj'), objText(wavyRing(8)));
        await writeFile(join(folder, 'page.ts'), page);
        await compile(folder, 'page.ts', {
          module: 'ESNext',
          moduleResolution: 'bundler',
          lib: ['ES2022', 'DOM', 'DOM.Iterable'],
          noEmit: true,
        });
        await writeFile(join(folder, 'program.ts'), program);
        await compile(folder, 'program.ts', {
          module: 'NodeNext',
          lib: ['ES2022', 'DOM', 'DOM.Iterable'],
          types: ['node'],
          typeRoots: [join(root, 'node_modules/@types')],
        });
        const { stdout } = await run(process.execPath, ['program.js'], { cwd: folder });
        expect(JSON.parse(stdout)).toEqual({ parts: 4, answer: 2, isLonger: true, after: 4 });

        const out = join(folder, 'command.fold');
        const options = '--parts 4 --seed 3 --height 80 --flap-side alternate --quiet'.split(' ');
        const ended = await foldwright([join(folder, 'ring.obj'), ...options, '-o', out]);
        expect(ended.status).toBe(0);
        expect(await readFile(join(folder, 'ring.fold'), 'utf8')).toBe(await readFile(out, 'utf8'));
      }),
    120_000,
  );
});
