/** The models and options that nets are judged by at large. */
import { readdirSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

export interface CorpusCase {
  model: string;
  /** Path of the model. */
  path: string;
  parts: '1' | '8' | 'auto';
}

/** Our own small models, which are always there. */
export function ownCases(): CorpusCase[] {
  const folder = fileURLToPath(new URL('../data/corpus', import.meta.url));
  return readdirSync(folder)
    .sort()
    .flatMap((model) =>
      (['1', '8', 'auto'] as const).map((parts) => ({ model, path: join(folder, model), parts })),
    );
}

const sizes = [300, 574, 1000, 2000, 3000];

function modelsIn(shared: string, most = Infinity): string[] {
  const listed = (folder: string) => readdirSync(join(shared, 'models', folder)).sort();
  const organic = listed('organic').filter((name) =>
    sizes.filter((faces) => faces <= most).includes(Number(/_(\d+)\.obj$/.exec(name)?.[1])),
  );
  const academic = listed('academic').filter((name) => /\.(obj|off)$/.test(name));
  return [
    ...organic.map((name) => join('organic', name)),
    ...academic.map((name) => join('academic', name)),
  ];
}

/** Every model in one part, in eight and in as many as it wants. */
export function corpusCases(shared: string): CorpusCase[] {
  return modelsIn(shared).flatMap((model) =>
    (['1', '8', 'auto'] as const).map((parts) => {
      return { model, path: join(shared, 'models', model), parts };
    }),
  );
}

/** The models whose sheets are judged at large: those that people would build. */
export function sheetCases(shared: string): Pick<CorpusCase, 'model' | 'path'>[] {
  return modelsIn(shared, 2000).map((model) => ({ model, path: join(shared, 'models', model) }));
}

/** Files that only belong to others, or tell people of them. */
const besides = /(?:\.(?:bin|jpe?g|md|mtl|png|svg|txt)|\/(?:LICENSE\b.*|COPYING\b.*))$/i;

/** Paths of all models below a folder of the shared ones, of whatever format, without the files that belong to them. */
export function modelsBelow(shared: string, folder: string): string[] {
  return readdirSync(join(shared, folder), { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(shared, join(entry.parentPath, entry.name)))
    .filter((path) => !besides.test(path))
    .sort();
}
