/** The two ways in, whatever they run on. */
import type { TimedResult } from '../core/client.js';
import type { Pool } from '../core/pool.js';
import type { ExportFormat, WrittenFile } from '../export/formats.js';
import type { FontLoader } from '../export/font-loader.js';
import type { RendererLoader } from '../export/renderer-loader.js';
import type { Report } from '../export/report.js';
import type { ModelFiles } from '../model/model-files.js';
import type { Options } from './written-options.js';
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
   * run, which rejects unless there is just one among them.
   */
  open: (files: ModelFiles, options?: OpenOptions) => Promise<Session>;
  /** Unfolds a model once; rejects as `open` and `Session.run` do. */
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

export function makeDoor({ startPool, ...loaders }: DoorOptions): Door {
  // Asynchronous, so that reading files of several kinds can become work.
  const open = async (
    files: ModelFiles,
    { pool, loadFont = loaders.loadFont, loadRenderer = loaders.loadRenderer }: OpenOptions = {},
  ): Promise<Session> => {
    if (files.length === 0) throw new TypeError('There is no file to open');
    const workers = pool ? lent(pool) : owned(startPool);
    return Promise.resolve(new Session(files, { ...workers, loadFont, loadRenderer }));
  };
  const unfold: Door['unfold'] = async (files, options = {}, work = {}) => {
    const session = await open(files, work);
    try {
      const report = await session.run(options, work);
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
  return { open, unfold };
}
