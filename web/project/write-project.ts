import { zipped } from '../export/zip.js';
import { normalized } from '../read/paths.js';
import { formatName, formatVersion, places, type Project } from './project.js';
import { resultsToJson } from './results-json.js';

/** What `project.json` holds. */
export interface ProjectJson {
  format: typeof formatName;
  version: number;
  app: string;
  name: string;
  /** The model's files by their names, and where they lie in the archive. */
  files: { name: string; entry: string }[];
  options: Project['options'];
  steps: Project['steps'];
  cursor: number;
  /** Of the result; null if only the run gives it. */
  hash: string | null;
}

/** Where files lie: below `files/`, by their names where these lead nowhere else and none is taken. */
export function entriesFor(names: readonly string[]): string[] {
  const taken = new Set<string>();
  return names.map((name, i) => {
    const isPlain = name !== '' && normalized(name) === name && !taken.has(name.toLowerCase());
    const path = isPlain ? name : `${i}/${name.replace(/^.*[/\\]/, '') || 'file'}`;
    taken.add(path.toLowerCase());
    return places.files + path;
  });
}

const utf8 = new TextEncoder();

function json(value: unknown): Uint8Array {
  return utf8.encode(`${JSON.stringify(value)}\n`);
}

/** The document in `project.json`. */
export function documentJson(project: Project): ProjectJson {
  const { app, name, files, options, steps, cursor, states } = project;
  const names = files.map((file) => file.name);
  const entries = entriesFor(names);
  return {
    format: formatName,
    version: formatVersion,
    app,
    name,
    files: names.map((own, i) => ({ name: own, entry: entries[i]! })),
    options,
    steps,
    cursor,
    hash: states[cursor]?.hash ?? null,
  };
}

/**
 * A project as one file. The same project gives the same bytes. What matters most comes first: of a file that
 * is cut off it is the end that is missing.
 */
export function writeProject(project: Project): Uint8Array {
  const document = documentJson(project);
  return zipped([
    { name: places.document, bytes: json(document) },
    ...project.files.map(({ bytes }, i) => ({ name: document.files[i]!.entry, bytes })),
    { name: places.results, bytes: json(resultsToJson(project.states)) },
  ]);
}
