/** Which models a batch is about. */
import { readFileSync, statSync } from 'node:fs';
import { resolve } from 'node:path';
import { isFoldName, isModelName } from '../../model/model-files.js';
import { projectEnding } from '../../project/project.js';
import { usageError } from '../exit.js';
import { filesIn, modelError, reasonOf } from '../read-model-files.js';
import { folderName, labelOf } from './names.js';

/** A model of a batch. */
export interface ListedModel {
  /** As it can be opened. */
  path: string;
  /** What people know it by. */
  label: string;
  /** The folder of its files, within the output folder; with slashes. */
  name: string;
}

function isModel(path: string): boolean {
  return isModelName(path) || path.toLowerCase().endsWith(projectEnding);
}

function isFolder(path: string): boolean {
  return statSync(path, { throwIfNoEntry: false })?.isDirectory() ?? false;
}

/** Of a folder and all in it; what a batch has written is not taken for models. */
function modelsIn(folder: string, out: string): string[] {
  const found: string[] = [];
  try {
    for (const { name, path } of filesIn(folder, '', (each) => resolve(each) !== out)) {
      if (isModel(name)) found.push(path);
    }
  } catch (error) {
    throw modelError(folder, reasonOf(error));
  }
  return found;
}

/** The lines of a list, which may have been written on any system. */
function linesOf(list: string): string[] {
  try {
    const text = readFileSync(list === '-' ? 0 : list, 'utf8');
    const lines = text.replace(/^\ufeff/, '').split(/\r?\n/);
    return lines.filter((line) => line.trim() !== '');
  } catch (error) {
    const told = reasonOf(error);
    throw usageError((words) => words.command.aboutFile(list, told(words)));
  }
}

function pathsOf(source: string, out: string): string[] {
  if (source !== '-' && isFolder(source)) return modelsIn(source, out);
  if (isModel(source) || isFoldName(source)) return [source];
  return linesOf(source).flatMap((line) => (isFolder(line) ? modelsIn(line, out) : [line]));
}

/**
 * All models of some sources, each once, in the order of their names.
 *
 * @param out the folder of all that is written
 * @throws Exit for a list that cannot be read, and if there is no model
 */
export function listModels(sources: readonly string[], out: string): ListedModel[] {
  const [first] = sources;
  // Who names one folder knows its models by their places in it.
  const base = sources.length === 1 && isFolder(first!) ? resolve(first!) : process.cwd();
  const byName = new Map<string, ListedModel>();
  for (const path of sources.flatMap((source) => pathsOf(source, resolve(out)))) {
    const name = folderName(resolve(path), base);
    const label = labelOf(resolve(path), base);
    if (!byName.has(name)) byName.set(name, { path, label, name });
  }
  if (byName.size === 0) throw modelError(sources.join(', '), ({ batch }) => batch.noModels);
  return [...byName.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
}
