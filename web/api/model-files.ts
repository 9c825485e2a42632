import type { ModelFile } from './work.js';

/** Endings of files that hold a model; others come along with one. */
const modelEndings = /\.(obj|stl|off|ply)$/i;

/** Files among which there is no model, or more than one; for people. */
export class BadFiles extends Error {
  override readonly name = 'BadFiles';
  readonly code = 'bad-files';
}

/**
 * The model among the files.
 * @throws BadFiles unless there is just one
 */
export function chooseModel(files: readonly ModelFile[]): ModelFile {
  const models = files.filter(({ name }) => modelEndings.test(name));
  const [model, second] = models.length === 0 && files.length === 1 ? files : models;
  if (!model) throw new BadFiles('There is no model among the files');
  if (second) throw new BadFiles(`There are two models: ${model.name} and ${second.name}`);
  return model;
}
