/** Entry of the worker that keeps projects, and reads and writes their files. */
import type { Message } from '../model/message.js';
import type { ModelFile } from '../model/model-files.js';
import type { Project, ReadProject } from '../project/project.js';
import { readProject } from '../project/read-project.js';
import { writeProject } from '../project/write-project.js';
import { readFoldedNets, type FoldedNets } from '../read/fold/folded-nets.js';
import { Unreadable } from '../read/unreadable.js';
import { thumbnail, type Portrait } from './thumbnail.js';
import type { Kept } from './model-file.js';
import { Shelf, type Card, type SaveOrder, type SaveOutcome } from './shelf.js';

/** What the worker does, by name. */
export interface ProjectCalls {
  cards(): Promise<Card[]>;
  tidy(): Promise<boolean>;
  /** Bytes that can be kept yet; null where the browser does not tell. */
  room(): Promise<number | null>;
  save(order: SaveOrder, portrait: Portrait | null): Promise<SaveOutcome>;
  load(id: string): Promise<{ project: Project; kept: Kept } | null>;
  rename(id: string, name: string): Promise<void>;
  remove(id: string, isRemoved: boolean): Promise<void>;
  copy(id: string, name: string): Promise<void>;
  /** A project as a file. */
  write(project: Project): Promise<Uint8Array>;
  /** What is in a file, or why nothing is. */
  read(file: ModelFile): Promise<{ read: ReadProject } | { failure: Message }>;
  /** The nets in a FOLD file, null for one that has none; or why it is none. */
  readNets(file: ModelFile): Promise<{ nets: FoldedNets | null } | { failure: Message }>;
}

/** Asks for one of them; comes with a port for the answer. */
export interface ProjectOrder {
  name: keyof ProjectCalls;
  args: unknown[];
}

/** `full`: there is no room on the device. `none`: nothing can be kept here. */
export type KeepingFault = 'full' | 'none';

export type ProjectAnswer =
  { type: 'done'; value: unknown } | { type: 'failed'; fault: KeepingFault; reason: string };

let opened: Shelf | null = null;
// Opened when it is first asked for, since reading and writing files do without.
const shelf = (): Shelf => (opened ??= new Shelf());

const isFull = (error: unknown): boolean =>
  error instanceof DOMException && error.name === 'QuotaExceededError';

/** Work that is wanted has more right to the room than what was deleted. */
async function savedWithRoom(order: SaveOrder): Promise<SaveOutcome> {
  try {
    return await shelf().save(order);
  } catch (error) {
    if (!isFull(error) || !(await shelf().tidy(0))) throw error;
    return shelf().save(order);
  }
}

/** What is read, or why it cannot be. */
function orFailure<Value>(read: () => Value): Promise<Value | { failure: Message }> {
  try {
    return Promise.resolve(read());
  } catch (error) {
    if (!(error instanceof Unreadable)) throw error;
    const { code, params } = error;
    return Promise.resolve({ failure: { code, params } });
  }
}

const calls: ProjectCalls = {
  cards: () => shelf().cards(),
  tidy: () => shelf().tidy(),
  async room() {
    // Browsers give it to pages of safe origins only.
    const storage = navigator.storage as StorageManager | undefined;
    const { quota, usage } = (await storage?.estimate()) ?? {};
    return quota === undefined || usage === undefined ? null : quota - usage;
  },
  async save(order, portrait) {
    const picture = portrait && (await thumbnail(portrait));
    return savedWithRoom({ ...order, picture });
  },
  load: (id) => shelf().load(id),
  rename: (id, name) => shelf().rename(id, name),
  remove: (id, isRemoved) => shelf().remove(id, isRemoved),
  copy: (id, name) => shelf().copy(id, name),
  write: (project) => Promise.resolve(writeProject(project)),
  read: (file) => orFailure(() => ({ read: readProject(file) })),
  readNets: (file) => orFailure(() => ({ nets: readFoldedNets(file) })),
};

async function answerTo({ name, args }: ProjectOrder): Promise<ProjectAnswer> {
  try {
    const all = calls as unknown as Record<string, (...own: unknown[]) => Promise<unknown>>;
    return { type: 'done', value: await all[name]!(...args) };
  } catch (error) {
    return { type: 'failed', fault: isFull(error) ? 'full' : 'none', reason: String(error) };
  }
}

addEventListener('message', ({ data, ports }: MessageEvent<ProjectOrder>) => {
  void answerTo(data).then((answer) => ports[0]?.postMessage(answer));
});
