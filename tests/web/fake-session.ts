/** A document without an engine, for tests of the store: every step waits until the test lets it go on. */
import type { DocumentState } from '../../web/api/document-state.js';
import { refusal, type Applied, type Refusal } from '../../web/api/edit-plan.js';
import type { Inspection } from '../../web/api/inspect.js';
import type { RunWork, WorkOptions } from '../../web/api/work.js';
import type { OpenModel } from '../../web/app/store-needs.js';
import type { TimedEvent } from '../../web/core/protocol.js';
import type { DocumentEdit } from '../../web/model/document-edits.js';
import { renamed } from '../../web/model/edits.js';
import type { PartName } from '../../web/model/job-options.js';
import type { Settings } from '../../web/model/options.js';
import type { Project } from '../../web/project/project.js';
import type { Report } from '../../web/export/report.js';

/** Faces side by side, more than tests have parts. */
const model = {
  vertices: Float64Array.from(
    Array.from({ length: 12 }, (_, i) => [10 * i, 0, 0, 10 * i + 5, 0, 5, 10 * i, 5, 0]).flat(),
  ),
  faces: Int32Array.from({ length: 36 }, (_, corner) => corner),
};

/** A result of so many parts of one face each, which are pieces as well. */
export function stateOf(settings: Settings, parts: number, names: PartName[] = []): DocumentState {
  const pieces = Array.from({ length: parts }, (_, part) => {
    const sources = Int32Array.of(part);
    return { part, sources, sheet: 0, x: part, y: 0, angle: 0 };
  });
  const labels = Int32Array.from(pieces, ({ part }) => part);
  const result = { model, parts, labels, names, pieces, scale: 1, notices: [] };
  const wishes = { settings, flapEdges: [], locks: [], names, pins: [] };
  const start = { labels, nets: [], netEdits: [], partEdits: [], paper: null };
  return { wishes, result: result as unknown as DocumentState['result'], start, isStopped: false };
}

function next(before: DocumentState, edits: readonly DocumentEdit[]): DocumentState | Refusal {
  const { wishes, result } = before;
  const [edit] = edits;
  if (edit?.kind === 'split') return stateOf(wishes.settings, result.parts + edit.into - 1);
  if (edit?.kind !== 'name') return refusal('bad-edit', { what: 'no-part-named' });
  if (edit.text.length > 16) return refusal('bad-option', { what: 'name-length' });
  return stateOf(wishes.settings, result.parts, renamed(result.names, edit.part - 1, edit.text));
}

export class FakeSession implements OpenModel {
  /** @param file name of the file that turns out to be the model */
  constructor(readonly file = 'ring.obj') {}

  private states: { state: DocumentState; edits: readonly DocumentEdit[] }[] = [];
  position = 0;
  settings: Settings | null = null;
  /** Settles the present work; rejects it if there is an error. */
  goOn: (error?: Error) => void = () => undefined;
  /** Whether a run that is stopped has nets to hand over, and whether that takes for ever. */
  isFruitful = true;
  isSlow = false;
  /** What the present work tells. */
  say: (event: object) => void = () => undefined;

  get lastStep(): readonly DocumentEdit[] | null {
    return this.position > 0 ? this.states[this.position]!.edits : null;
  }

  get before(): DocumentState['result'] | null {
    return this.states[this.position - 1]?.state.result ?? null;
  }

  get nextStep(): readonly DocumentEdit[] | null {
    return this.states[this.position + 1]?.edits ?? null;
  }

  /** What a look at the model finds; none unless a test says so. */
  inspection: Partial<Inspection> = {};

  async inspect(_: unknown, { signal }: Pick<WorkOptions, 'signal'> = {}): Promise<Inspection> {
    await this.wait({ ...(signal && { signal }) });
    const model = { vertices: new Float32Array(9), faces: Int32Array.of(0, 1, 2) };
    const components = [{ faces: 1, longestSide: 1 }];
    const componentOfFaces = Int32Array.of(0);
    return {
      file: this.file,
      model,
      repairs: [],
      components,
      componentOfFaces,
      fileNets: 0,
      ...this.inspection,
    };
  }

  async runWith(settings: Settings, work: RunWork = {}): Promise<Report> {
    await this.wait(work);
    const { file } = this;
    work.onEvent?.({ type: 'model', file } as TimedEvent);
    this.settings = settings;
    this.states = [{ state: this.named(stateOf(settings, 4)), edits: [] }];
    return {} as Report;
  }

  async apply(
    asked: DocumentEdit | readonly DocumentEdit[],
    work: WorkOptions = {},
  ): Promise<Applied | Refusal> {
    const edits = asked as readonly DocumentEdit[];
    await this.wait(work);
    const state = next(this.states[this.position]!.state, edits);
    if ('ok' in state) return state;
    this.states = [...this.states.slice(0, ++this.position), { state: this.named(state), edits }];
    return { ok: true, changed: [] };
  }

  undo(): boolean {
    return this.move(-1);
  }

  redo(): boolean {
    return this.move(1);
  }

  state(): Promise<DocumentState> {
    return Promise.resolve(this.states[this.position]!.state);
  }

  project(): Project {
    throw new Error('Nobody keeps it here');
  }

  private named(state: DocumentState): DocumentState {
    return { ...state, result: { ...state.result, file: this.file } };
  }

  private move(by: number): boolean {
    if (!this.states[this.position + by]) return false;
    this.position += by;
    return true;
  }

  private async wait({ signal, stop, onEvent }: RunWork): Promise<void> {
    signal?.throwIfAborted();
    this.say = (event) => onEvent?.(event as TimedEvent);
    await new Promise<void>((resolve, reject) => {
      this.goOn = (error) => (error ? reject(error) : resolve());
      signal?.addEventListener('abort', () => reject(signal.reason as Error));
      stop?.addEventListener('abort', () => {
        if (this.isSlow) return;
        if (!this.isFruitful) return reject(stop.reason as Error);
        this.say({ type: 'cancelled' });
        resolve();
      });
    });
  }
}
