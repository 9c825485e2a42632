/** Makes one file that the engine reads of whatever files a model comes in. */
import type { Message } from '../model/message.js';
import type { ModelFile, ModelFiles } from '../model/model-files.js';
import { Archive, isOfPerson } from './archive.js';
import { Companions, sourceOf, type FileSource } from './companions.js';
import { engineFile } from './engine-file.js';
import { formatOfFile, isPackage, modelPaths, modelsAmong, type Format } from './format.js';
import { loaded } from './loading.js';
import { companionsOf } from './named-files.js';
import { notice, type ReaderTools, type ReadModel } from './read-model.js';
import { unreadable } from './unreadable.js';

async function read(
  file: ModelFile,
  format: Format | null,
  companions: Companions,
  tools: ReaderTools,
): Promise<ReadModel> {
  const { name } = file;
  // Loaded when they are needed: most models are not of these formats.
  if (format === '3mf') {
    const { readThreeMf } = await loaded(() => import('./3mf/read-3mf.js'));
    const { soup, ...rest } = readThreeMf(file);
    const usual = { up: 'z', unit: 'mm' } as const;
    return { name, file: engineFile(soup), companions: [], usual, ...rest };
  }
  if (format === 'pdo') {
    const { readPdo } = await loaded(() => import('./pdo/read-pdo.js'));
    const { nets, ...rest } = readPdo(file);
    const usual = { up: 'y', unit: 'mm' } as const;
    return { name, companions: [], usual, ...rest, ...(nets && { nets }) };
  }
  if (format === 'fold') {
    const { readFold } = await loaded(() => import('./fold/read-fold.js'));
    return { name, companions: [], ...readFold(file) };
  }
  if (format === 'glb' || format === 'gltf') {
    const { readGltf } = await loaded(() => import('./gltf/read-gltf.js'));
    const { soup, ...rest } = await readGltf(file, format === 'glb', companions, tools);
    const usual = { up: 'y', unit: 'm' } as const;
    return { name, file: engineFile(soup), companions: [], usual, ...rest };
  }
  const named = companionsOf(file, (address, base) => companions.find(address, base));
  return { name, file, looks: null, companions: named, notices: [], usual: {} };
}

function ignored(files: readonly string[]): Message[] {
  return files.length === 0 ? [] : [notice('files-ignored', { files: [...files] })];
}

function severalModels(names: readonly string[]): Error {
  const [first, second] = names as [string, string];
  return unreadable('several-models', { count: names.length, first, second });
}

async function readAmong(
  source: FileSource,
  path: string,
  tools: ReaderTools,
): Promise<{ model: ReadModel; unused: string[] }> {
  const file = source.read(path);
  const companions = new Companions(source, path);
  const model = await read(file, formatOfFile(file), companions, tools);
  return { model, unused: companions.unused };
}

/** Of several models in an archive the one that lies least deep is read, and of these the first by name. */
async function readArchive(file: ModelFile, tools: ReaderTools): Promise<ReadModel> {
  const archive = new Archive(file);
  if (isPackage(archive.paths))
    return read(file, '3mf', new Companions(sourceOf([]), file.name), tools);
  const paths = archive.paths.filter(isOfPerson);
  const source: FileSource = { paths, read: (path) => archive.read(path) };
  const [chosen, ...others] = modelPaths(paths);
  if (chosen === undefined)
    throw unreadable('no-model-in-archive', { file: file.name, files: paths });
  const { model, unused } = await readAmong(source, chosen, tools);
  const notices = [...model.notices];
  if (others.length > 0) {
    notices.unshift(notice('archive-choice', { file: chosen, others }));
  }
  notices.push(...ignored(unused.filter((path) => !others.includes(path))));
  return { ...model, notices };
}

/**
 * Reads a model that the engine cannot read by itself, from memory alone. Cost: the time of unpacking and
 * decoding, and memory of several times the size of the files; call it in a worker.
 *
 * @throws Unreadable for files that give no model
 */
export async function readFiles(files: ModelFiles, tools: ReaderTools): Promise<ReadModel> {
  const models = modelsAmong(files);
  if (models.length > 1) throw severalModels(models.map(({ name }) => name));
  if (models.length === 1) {
    const { model, unused } = await readAmong(sourceOf(files), models[0]!.name, tools);
    return { ...model, notices: [...model.notices, ...ignored(unused)] };
  }
  const archives = files.filter((file) => formatOfFile(file) === 'zip');
  if (archives.length === 0) throw unreadable('no-model', { count: files.length });
  if (archives.length !== 1) throw severalModels(archives.map(({ name }) => name));
  return readArchive(archives[0]!, tools);
}
