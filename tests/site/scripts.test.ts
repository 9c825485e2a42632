/** Every example in TypeScript or JavaScript passes the compiler, and does what it says. */
import { copyFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import ts from 'typescript';
import { expect, test } from 'vitest';
import { inFolder } from '../web/command.js';
import { compile, install, root, run } from '../web/packed.js';
import { examplesOf } from './examples.js';
import { withShopPage } from './shop-page.js';

const sample = (name: string): string => join(root, 'dist/studio/samples', name);

/** What an example takes for granted, by the page that it is on. */
const beforeIt: Readonly<Record<string, string>> = {
  'README.md': `
    import { readFileSync, writeFileSync } from 'node:fs';
    const bytes: Uint8Array = readFileSync('whale.obj');
    const save = (name: string, written: Uint8Array): void => writeFileSync(name, written);`,
  'docs/package.md': 'const show = (report: { parts: number }): void => console.log(report.parts);',
};

/** Names of node that the examples use, for a compiler without its types. */
const node = `
  declare module 'node:fs' {
    export function readFileSync(path: string): Uint8Array;
    export function writeFileSync(path: string, bytes: Uint8Array): void;
  }`;

/** In a document of its own each example ends as a module does. */
const moduleOf = (source: string, code: string): string =>
  `${beforeIt[source] ?? ''}\n${code}\nexport {};\n`;

const how = { module: 'ESNext', moduleResolution: 'bundler', noEmit: true, skipLibCheck: true };

test.each(examplesOf('ts'))('$name passes the compiler and runs', ({ source, code }) =>
  inFolder(async (folder) => {
    await install(folder, ['@types/react', 'csstype']);
    const text = moduleOf(source, code);
    await writeFile(join(folder, 'example.ts'), text);
    await writeFile(join(folder, 'node.d.ts'), node);
    await compile(folder, ['example.ts', 'node.d.ts'], how);
    await copyFile(sample('whale.obj'), join(folder, 'whale.obj'));
    const target = { module: ts.ModuleKind.ESNext, target: ts.ScriptTarget.ES2022 };
    const { outputText } = ts.transpileModule(text, { compilerOptions: target });
    await writeFile(join(folder, 'example.mjs'), outputText);
    await run(process.execPath, ['example.mjs'], { cwd: folder });
  }),
);

test.each(examplesOf('tsx'))('the example in $name is known to the compiler', ({ source, code }) =>
  inFolder(async (folder) => {
    await install(folder, ['@types/react', 'csstype']);
    const used = code.trim().replace(/^</, 'export const element = <');
    const text = `import type {} from 'foldwright/jsx/react';\n${moduleOf(source, used)}`;
    await writeFile(join(folder, 'example.tsx'), text);
    await compile(folder, ['example.tsx'], { ...how, jsx: 'react-jsx' });
  }),
);

test.each(examplesOf('js'))('$name runs in a page', async ({ code }) => {
  const markup = '<foldwright-viewer></foldwright-viewer>';
  const script = '<script type="module" src="foldwright/foldwright-viewer.js"></script>';
  await withShopPage(script + markup, async ({ page, complaints }) => {
    // What it says with `const` is of its own block, and its last line is waited for.
    await page.evaluate(`(async () => {\n${code}\n})()`);
    expect(complaints).toEqual([]);
  });
});
