/** The package as others get it: packed, installed into an empty project, and called from there. */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldwright, inFolder, isBuilt } from './command.js';
import { objText, wavyRing } from './model-text.js';
import { compile, install, root, run } from './packed.js';

/** Written as a stranger would, from the README. */
const program = `
import { readFile, writeFile } from 'node:fs/promises';
import { open, unfold, type DocumentEdit, type Options } from 'foldwright';
// Pages are also made where there is no DOM.
import 'foldwright/viewer';

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
import { FoldwrightViewer } from 'foldwright/viewer';

const pool = startPool(2, { worker: 'https://example.com/worker.js' });
await unfold([], { paper: 'A3' }, { pool, onEvent: (event) => console.log(event.type) });
document.createElement('foldwright-studio').addEventListener('foldwright-event', ({ detail }) => {
  console.log(detail.type);
});
const viewer: FoldwrightViewer = document.createElement('foldwright-viewer');
viewer.addEventListener('before-download', (event) => {
  if (event.detail.format === 'pdf') event.preventDefault();
});
await viewer.loadModel('whale.fold');
await viewer.foldTo(0.5);
viewer.view = 'both';
viewer.targetSize = '120';
const project: { name: string; bytes: Uint8Array } = await viewer.saveProject();
console.log(project.name);
// @ts-expect-error there is no such paper option
await unfold([], { papier: 'A3' });
`;

describe.skipIf(!isBuilt)('the package', () => {
  it(
    'is typed, and gives under node what the command line gives',
    () =>
      inFolder(async (folder) => {
        await install(folder);
        await writeFile(join(folder, 'ring.obj'), objText(wavyRing(8)));
        await writeFile(join(folder, 'page.ts'), page);
        await compile(folder, ['page.ts'], {
          module: 'ESNext',
          moduleResolution: 'bundler',
          noEmit: true,
        });
        await writeFile(join(folder, 'program.ts'), program);
        await compile(folder, ['program.ts'], {
          module: 'NodeNext',
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
    // Compiled twice with all its types.
    600_000,
  );
});
