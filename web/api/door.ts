/** The two ways in, whatever they run on. */
import type { TimedResult } from '../core/client.js';
import { JobError } from '../core/job-error.js';
import type { Pool } from '../core/pool.js';
import type { ExportFormat, WrittenFile } from '../export/formats.js';
import type { FontLoader } from '../export/font-loader.js';
import type { RendererLoader } from '../export/renderer-loader.js';
import type { Report } from '../export/report.js';
import type { ModelFile, ModelFiles } from '../model/model-files.js';
import { isProject } from '../project/is-project.js';
import type { ReadProject } from '../project/project.js';
import { Unreadable } from '../read/unreadable.js';
import { goOn } from './go-on.js';
import { nameOf, type Options } from './written-options.js';
import { Session, type Surroundings } from './session.js';
import type { RunWork } from './work.js';

export interface OpenOptions {
  /**
   * Workers to share with others, from `startPool`, which also takes the addresses of worker and WASM
   * where a host keeps them elsewhere, or what gives them when they are first needed; without it the
   * session starts its own and ends them.
   */
  pool?: Pool | (() => Pool);
  /** Gets fonts by the names of their files, where they are not beside the package's own. */
  loadFont?: FontLoader;
  /** Gets the WASM that draws PNG files, where it is not beside the package's own. */
  loadRenderer?: RendererLoader;
}

/** What came out of a model, ready to be written. */
export interface Unfolded {
  readonly report: Report;
  /** All of it, as plain data. */
  readonly result: TimedResult;
  /** Writes it in a format; see `Session.export`. */
  export(format: ExportFormat, options?: Options): Promise<WrittenFile[]>;
}

export interface Door {
  /**
   * Opens a model: its file, and those that belong to it. Which one it is, the contents say when it is first
   * run, which rejects unless there is just one among them. A project (`.foldwright`) is opened with its edits
   * and their history, and whatever else is among the files is left alone; it needs no run, and its result is
   * computed when it is first asked for. Rejects with a `JobError` for a project that holds no model any more.
   */
  open: (files: ModelFiles, options?: OpenOptions) => Promise<Session>;
  /** Opens a project that was read already. @internal */
  reopen: (read: ReadProject, options?: OpenOptions) => Promise<Session>;
  /**
   * Unfolds a model once; rejects as `open` and `Session.run` do. A project has its own options for all that are not
   * given, and its edits; it rejects with a `JobError` if these cannot be made under the options that are given.
   */
  unfold: (files: ModelFiles, options?: Options, work?: RunWork & OpenOptions) => Promise<Unfolded>;
}

/** What a door needs of where it stands. */
export interface DoorOptions {
  startPool: () => Pool;
  loadFont: FontLoader;
  loadRenderer: RendererLoader;
}

type Workers = Pick<Surroundings, 'pool' | 'close'>;

function lent(pool: Pool | (() => Pool)): Workers {
  return { pool: typeof pool === 'function' ? pool : () => pool };
}

/** Started when they are needed first. */
function owned(start: () => Pool): Workers {
  let pool: Pool | null = null;
  return { pool: () => (pool ??= start()), close: () => pool?.close() };
}

/** Loaded when it is needed: most files are no projects. */
async function readNow(file: ModelFile): Promise<ReadProject> {
  const { readProject } = await import('../project/read-project.js');
  try {
    return readProject(file);
  } catch (error) {
    throw error instanceof Unreadable ? new JobError(error.code, error.params) : error;
  }
}

/** What a project comes to under other options. */
async function reopened(session: Session, options: Options, work: RunWork): Promise<Report> {
  const given = Object.entries(options).map(([key, value]) => [nameOf(key), value]);
  const blocked = await goOn(session, Object.fromEntries(given) as Record<string, unknown>, work);
  if (blocked) throw new JobError(blocked.refusal.code, blocked.refusal.params);
  return session.report;
}

export function makeDoor({ startPool, ...loaders }: DoorOptions): Door {
  const around = ({ pool, ...own }: OpenOptions): Surroundings => {
    const workers = pool ? lent(pool) : owned(startPool);
    const { loadFont = loaders.loadFont, loadRenderer = loaders.loadRenderer } = own;
    return { ...workers, loadFont, loadRenderer };
  };
  const reopen: Door['reopen'] = (read, options = {}) =>
    Promise.resolve(new Session(read.project.files, around(options), read));
  const open: Door['open'] = async (files, options = {}) => {
    if (files.length === 0) throw new TypeError('There is no file to open');
    const project = files.find(isProject);
    return project ? reopen(await readNow(project), options) : new Session(files, around(options));
  };
  const unfold: Door['unfold'] = async (files, options = {}, work = {}) => {
    const session = await open(files, work);
    try {
      const isOpened = session.settings !== null;
      const report = await (isOpened
        ? reopened(session, options, work)
        : session.run(options, work));
      const result = await session.result();
      return {
        report,
        result,
        async export(format, look = {}) {
          try {
            return await session.export(format, look);
          } finally {
            session.close();
          }
        },
      };
    } finally {
      // Workers of its own are started again if an export needs another layout.
      session.close();
    }
  };
  return { open, reopen, unfold };
}
