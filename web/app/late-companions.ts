/** Files that are chosen after the model that they belong to. */
import type { ModelFile } from '../model/model-files.js';
import { formatOf } from '../read/format.js';
import type { ChosenModel } from './model-file.js';

/** What models are made of besides themselves: materials, pictures, and the data of glTF files. */
const companionEnding = /\.(?:mtl|bin|png|jpe?g|gif|webp|bmp|tga)$/i;

function isCompanion({ name, bytes }: ModelFile): boolean {
  return companionEnding.test(name) && formatOf(bytes) === null;
}

/** Whether files can only belong to a model that was chosen before. */
export function areCompanions({ files }: ChosenModel): boolean {
  return files.every(isCompanion);
}

/** A model with files that were chosen after it; they take the place of others of their names. */
export function joinedBy(model: ChosenModel, { files }: ChosenModel): ChosenModel {
  const names = files.map(({ name }) => name);
  const before = model.files.filter(({ name }) => !names.includes(name));
  const added = [...(model.added ?? []).filter((name) => !names.includes(name)), ...names];
  return { ...model, files: [...before, ...files], added };
}
