/** Types for JSX, in a project with the libraries' own types. */
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { inFolder } from '../web/command.js';
import { compile, install } from '../web/packed.js';

/** Where each library has its types, and what it writes before the name of an event. */
const libraries = [
  { name: 'react', source: 'react', prefix: 'on' },
  { name: 'preact', source: 'preact', prefix: 'on' },
  { name: 'solid', source: 'solid-js', prefix: 'on:' },
] as const;

/** The packages that have these types. */
const packages = ['@types/react', 'csstype', 'preact', 'solid-js'];

const page = ({ name, source, prefix }: (typeof libraries)[number]): string => `
/** @jsxImportSource ${source} */
import type {} from 'foldwright/jsx/${name}';

export const viewer = (
  <foldwright-viewer
    id="whale" src="whale.fold" parts={6} target-size="120" lang="de" view="both" controls
    ${prefix}unfold={({ detail }) => console.log(detail.report.parts)}
    ${prefix}fold-change={({ detail }) => console.log(detail.time)}
  />
);
export const studio = (
  <foldwright-studio src="whale.obj" whole-page ${prefix}foldwright-event={({ detail }) => console.log(detail.type)} />
);
// @ts-expect-error there is no such attribute
export const unknown = <foldwright-viewer papier="A3" />;
// @ts-expect-error it is there or not
export const word = <foldwright-viewer controls="some" />;
`;

test('React, Preact and Solid know the elements', () =>
  inFolder(async (folder) => {
    await install(folder, packages);
    for (const library of libraries) {
      await writeFile(join(folder, `${library.name}.tsx`), page(library));
    }
    const files = libraries.map(({ name }) => `${name}.tsx`);
    const how = { module: 'ESNext', moduleResolution: 'bundler', jsx: 'react-jsx', noEmit: true };
    const compiled = compile(folder, files, { ...how, skipLibCheck: true });
    await expect(compiled).resolves.toBeUndefined();
  }));
