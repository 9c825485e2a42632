import { editsFault, type DocumentEdit } from '../model/document-edits.js';
import type { Message } from '../model/message.js';
import { probableModel, type ModelFile } from '../model/model-files.js';
import { Archive } from '../read/archive.js';
import { foundEntries } from '../read/found-entries.js';
import { Unreadable, unreadable } from '../read/unreadable.js';
import type { Messages } from '../words/messages.js';
import { formatName, formatVersion, places, type Project, type ReadProject } from './project.js';
import { statesFromJson } from './results-json.js';
import { isRecord, listOf, record, text } from './shapes.js';
import type { ProjectJson } from './write-project.js';

const utf8 = new TextDecoder();

/** Longer names are in no list. */
const longestName = 200;

/** What can be had of an archive: by its list, or else by what is found in it. */
class Contents {
  private readonly sources: Archive[];

  constructor(file: ModelFile) {
    const openings = [() => new Archive(file), () => new Archive(file, foundEntries)];
    this.sources = openings.flatMap((open) => attempt(open) ?? []);
  }

  get paths(): string[] {
    return [...new Set(this.sources.flatMap(({ paths }) => paths))];
  }

  /** Null for what is damaged, or not there. */
  read(path: string): Uint8Array | null {
    for (const source of this.sources) {
      if (!source.paths.includes(path)) continue;
      const file = attempt(() => source.read(path));
      if (file) return file.bytes;
    }
    return null;
  }

  json(path: string): unknown {
    const bytes = this.read(path);
    return bytes && attempt(() => JSON.parse(utf8.decode(bytes)) as unknown);
  }
}

/** Null where that fails for what the file holds. */
function attempt<Value>(work: () => Value): Value | null {
  try {
    return work();
  } catch (error) {
    if (error instanceof Unreadable || error instanceof SyntaxError) return null;
    throw error;
  }
}

function fault(params: Messages['project-damaged'] & Message['params']): Message {
  return { code: 'project-damaged', params };
}

const isDocument = record(
  { format: text, options: isRecord, files: listOf(record({ name: text, entry: text })) },
  { app: text, name: text },
);

/** The document of a project; null if it is damaged. @throws Unreadable for one of a version to come */
function documentOf(contents: Contents, file: string): ProjectJson | null {
  const value = contents.json(places.document);
  if (!isRecord(value) || value['format'] !== formatName) return null;
  const version = Number(value['version']);
  if (version > formatVersion) throw unreadable('bad-project', { file, what: 'newer', version });
  return isDocument(value) ? (value as unknown as ProjectJson) : null;
}

/** What is left of the model's files, and the names of those that are not. */
function filesOf(
  contents: Contents,
  listed: ProjectJson['files'],
): { files: ModelFile[]; lost: string[] } {
  const files: ModelFile[] = [];
  const lost: string[] = [];
  for (const { name, entry } of listed) {
    const bytes = contents.read(entry);
    if (bytes) files.push({ name, bytes });
    else lost.push(name);
  }
  return { files, lost };
}

/** Steps up to the first one that is none. */
function soundSteps(value: unknown): DocumentEdit[][] {
  const steps = Array.isArray(value) ? (value as unknown[]) : [];
  const isStep = (step: unknown): boolean =>
    Array.isArray(step) && step.length > 0 && editsFault(step) === null;
  const end = steps.findIndex((step) => !isStep(step));
  return (end < 0 ? steps : steps.slice(0, end)) as DocumentEdit[][];
}

/** Files that are there without a document that lists them. */
function listedFiles({ paths }: Contents): ProjectJson['files'] {
  return paths
    .filter((path) => path.startsWith(places.files))
    .map((entry) => ({ name: entry.slice(places.files.length), entry }));
}

function projectOf(
  contents: Contents,
  document: ProjectJson,
): Omit<Project, 'files'> & { lost: number } {
  const { app = '', name = '', options } = document;
  const steps = soundSteps(document.steps);
  const all = Array.isArray(document.steps) ? document.steps.length : 0;
  const wanted = Number.isInteger(document.cursor) ? document.cursor : all;
  const cursor = Math.max(0, Math.min(wanted, steps.length));
  const states = statesFromJson(contents.json(places.results), steps.length + 1);
  const lost = all - steps.length;
  return { app, name: name.slice(0, longestName), options, steps, cursor, states, lost };
}

/**
 * Reads a project. Of one that is damaged all that is sound is there, and `faults` say what is not.
 *
 * @throws Unreadable if no model is left, or the file is of a version to come
 */
export function readProject(file: ModelFile): ReadProject {
  const contents = new Contents(file);
  const document = documentOf(contents, file.name);
  const listed = document?.files ?? listedFiles(contents);
  const { files, lost } = filesOf(contents, listed);
  const model = probableModel(listed.map(({ name }) => ({ name, bytes: new Uint8Array() })));
  if (files.length === 0 || lost.includes(model)) {
    throw unreadable('bad-project', { file: file.name, what: 'damaged' });
  }
  const faults = lost.length > 0 ? [fault({ what: 'files', files: lost })] : [];
  if (!document) {
    const bare = { app: '', name: '', options: {}, steps: [], cursor: 0, states: [null] };
    return { project: { ...bare, files }, faults: [fault({ what: 'document' }), ...faults] };
  }
  const { lost: lostSteps, ...project } = projectOf(contents, document);
  if (lostSteps > 0) faults.push(fault({ what: 'edits', count: lostSteps }));
  return { project: { ...project, files }, faults };
}
