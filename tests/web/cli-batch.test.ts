/** Many models by one command: what it writes and tells, and that it goes on after any end. */
import { mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { BatchEnd, BatchEvent } from '../../web/cli/batch/batch-events.js';
import { foldwright, inFolder, isBuilt, type CommandOptions, type Ended } from './command.js';
import { objText, wavyRing } from './model-text.js';
import { batchSchemaErrors, schemaErrors } from './report-schema.js';

const small = objText(wavyRing(6));
const damaged = 'v 0 0 0\nf 1 2 x\n';

/** Commands that follow each other, on a machine that has other things to do. */
const patience = 180_000;

/** Two models of one name, one that cannot be read, and one whose name is no HTML. */
const catalogue: Record<string, string> = {
  'ring.obj': small,
  'b/ring.obj': objText(wavyRing(8)),
  'b/broken.obj': damaged,
  'b/read me.txt': 'no model',
  "<i>&'.obj": small,
};

function fill(folder: string, files: Record<string, string>): void {
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
}

/** All files below a folder with their contents, hidden ones as well. */
function contents(folder: string): Record<string, string> {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => !entry.isDirectory())
    .map(({ name, parentPath }) => join(parentPath, name));
  const named = files.map((path) => [relative(folder, path), readFileSync(path, 'latin1')]);
  return Object.fromEntries(named.sort(([a], [b]) => (a! < b! ? -1 : 1))) as Record<string, string>;
}

function eventsOf({ stdout }: Ended): BatchEvent[] {
  const lines = stdout.split('\n').filter((line) => line !== '');
  return lines.map((line) => JSON.parse(line) as BatchEvent);
}

function endOf(ended: Ended): BatchEnd {
  return eventsOf(ended).at(-1) as BatchEnd;
}

const options = ['--parts', '2', '--runs', '20', '--compact', 'off', '--folding', 'off'];

function batch(
  source: string,
  out: string,
  more: string[] = [],
  run?: CommandOptions,
): Promise<Ended> {
  return foldwright(['batch', source, '--out', out, ...options, ...more], run);
}

/** Does `work` with the catalogue in a folder of its own, and a folder for what comes of it. */
function withCatalogue(work: (models: string, folder: string) => Promise<void>): Promise<void> {
  return inFolder((folder) => {
    const models = join(folder, 'models');
    fill(models, catalogue);
    return work(models, folder);
  });
}

describe.skipIf(!isBuilt)('a batch', () => {
  it('does all models but those that cannot be used, and tells it in lines of JSON', () =>
    withCatalogue(async (models, folder) => {
      const out = join(folder, 'out');
      const ended = await batch(models, out, ['--format', 'report,fold']);
      expect(ended.status).toBe(3);
      expect(ended.stderr).toContain(`${join(models, 'b/broken.obj')}: line 2: `);
      const events = eventsOf(ended);
      expect(events.flatMap(batchSchemaErrors)).toEqual([]);
      expect(endOf(ended)).toEqual({
        type: 'end',
        done: 3,
        skipped: 0,
        refused: ['b/broken.obj'],
        failed: [],
        left: 0,
      });
      const written = contents(out);
      const report = JSON.parse(written['b/ring.obj/ring.json']!) as { files: string[] };
      expect(schemaErrors(report)).toEqual([]);
      expect(report.files).toEqual(['ring.fold', 'ring.json']);
      expect(Object.keys(written).filter((name) => name.startsWith('b/'))).toEqual([
        'b/broken.obj/broken.record.json',
        'b/ring.obj/ring.fold',
        'b/ring.obj/ring.json',
        'b/ring.obj/ring.picture.png',
        'b/ring.obj/ring.record.json',
      ]);
      const alone = join(folder, 'alone.fold');
      await foldwright([join(models, 'b/ring.obj'), '-o', alone, ...options]);
      expect(written['b/ring.obj/ring.fold']).toBe(readFileSync(alone, 'latin1'));
    }));

  it('shows what there is on a page, whatever models are called', () =>
    withCatalogue(async (models, folder) => {
      const out = join(folder, 'out');
      await batch(models, out, ['--format', 'svg']);
      const page = readFileSync(join(out, 'index.html'), 'utf8');
      expect(page).toContain("<h2>&lt;i&gt;&amp;'.obj</h2>");
      expect(page).not.toContain('<i>');
      expect(page).toContain('<strong>b/broken.obj</strong>: line 2: ');
      const links = [...page.matchAll(/href="([^"]+)"/g)].map(([, address]) => address!);
      expect(links.length).toBeGreaterThanOrEqual(3);
      for (const address of links) {
        const path = decodeURIComponent(address.replaceAll('&amp;', '&'));
        expect(statSync(join(out, path)).size).toBeGreaterThan(0);
      }
      expect(page.match(/src="data:image\/png;base64,/g)).toHaveLength(3);
    }));

  it(
    'that was killed goes on, to the same bytes',
    () =>
      withCatalogue(async (models, folder) => {
        const [whole, killed] = [join(folder, 'whole'), join(folder, 'killed')];
        await batch(models, whole);
        const after = '"type":"done"';
        const first = await batch(models, killed, [], { interrupt: 'SIGKILL', after });
        expect(first.status).toBeNull();
        const second = await batch(models, killed);
        expect(second.status).toBe(3);
        expect(endOf(second).skipped).toBeGreaterThanOrEqual(1);
        expect(contents(killed)).toEqual(contents(whole));
      }),
    patience,
  );

  it('that is interrupted ends with a page of what there is', () =>
    withCatalogue(async (models, folder) => {
      const out = join(folder, 'out');
      const after = '"type":"done"';
      const ended = await batch(models, out, ['--workers', '1'], { interrupt: 'SIGINT', after });
      expect(ended.status).toBe(4);
      expect(endOf(ended).left).toBeGreaterThan(0);
      expect(ended.stderr).toMatch(/the same command goes on from here\n$/);
      expect(readFileSync(join(out, 'index.html'), 'utf8')).toContain('not done yet');
    }));

  it(
    'does only that again which has changed or is not there any more',
    () =>
      withCatalogue(async (models, folder) => {
        const out = join(folder, 'out');
        const again = (more: string[] = []): Promise<Ended> =>
          batch(models, out, ['--format', 'fold', ...more]);
        await again();
        expect(endOf(await again())).toMatchObject({ done: 0, skipped: 3 });
        fill(models, { 'ring.obj': objText(wavyRing(7)), 'b/broken.obj': small });
        expect(endOf(await again())).toMatchObject({ done: 2, skipped: 2, refused: [] });
        rmSync(join(out, 'b/ring.obj/ring.fold'));
        expect(endOf(await again())).toMatchObject({ done: 1, skipped: 3 });
        const other = await again(['--seed', '2']);
        expect(endOf(other)).toMatchObject({ done: 4, skipped: 0 });
      }),
    patience,
  );

  it(
    'may be shared out, and takes a list',
    () =>
      withCatalogue(async (models, folder) => {
        const [whole, shared] = [join(folder, 'whole'), join(folder, 'shared')];
        const list = join(folder, 'list.txt');
        const names = ['ring.obj', 'b/ring.obj', 'missing.obj', 'ring.obj'];
        writeFileSync(list, names.map((name) => `${join(models, name)}\r\n`).join(''));
        const ended = await batch(list, whole);
        expect(ended.stderr).toContain('missing.obj: there is no such file');
        const one = await batch(list, shared, ['--shard', '1/2']);
        expect(readdirSync(shared)).not.toContain('index.html');
        const two = await batch(list, shared, ['--shard', '2/2']);
        expect(endOf(one).done + endOf(two).done).toBe(endOf(ended).done);
        expect(endOf(ended)).toMatchObject({ done: 2, skipped: 0, refused: [expect.any(String)] });
        expect(contents(shared)).toEqual(contents(whole));
      }),
    patience,
  );

  it('refuses what it cannot do', () =>
    inFolder(async (folder) => {
      const refused = async (...args: string[]): Promise<[number | null, string]> => {
        const { status, stderr, stdout } = await foldwright(['batch', ...args]);
        expect(stdout).toBe('');
        return [status, stderr];
      };
      const out = join(folder, 'out');
      expect(await refused(folder)).toEqual([2, expect.stringContaining("'--out <dir>' not sp")]);
      expect((await refused(folder, '--out', out))[0]).toBe(3);
      expect(await refused(join(folder, 'no list'), '--out', out)).toEqual([
        2,
        expect.stringContaining('there is no such file'),
      ]);
      for (const [name, value] of [
        ['--format', 'pdf,doc'],
        ['--shard', '3/2'],
      ] as const) {
        expect(await refused(folder, '--out', out, name, value)).toEqual([
          2,
          expect.stringContaining(`'${name}'`),
        ]);
      }
    }));
});
