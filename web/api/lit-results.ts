/** Results with the surface whose light is printed on them. */
import type { TimedResult } from '../core/client.js';
import { originalOf } from '../model/looks.js';
import { printsShading } from '../model/print-options.js';
import { jobOf, printOf, type DocumentState } from './document-state.js';
import { wholeModel } from './inspect.js';
import type { OpenedModel } from './opened-model.js';
import type { WorkOptions } from './work.js';

/** Fetches the surface of a model before it was simplified, for results whose looks do not have it. */
export class LitResults {
  private readonly known = new WeakMap<TimedResult, TimedResult>();

  constructor(private readonly model: OpenedModel) {}

  /** A state whose result can be printed as it is asked for. Cost: reading the model, unless the engine still has it. */
  async of<State extends Pick<DocumentState, 'wishes' | 'result'>>(
    state: State,
    { signal }: WorkOptions,
  ): Promise<State> {
    const { wishes, result } = state;
    const isLacking = result.deviation > 0 && originalOf(result) === null;
    if (!isLacking || !printsShading(printOf(wishes))) return state;
    const before = this.known.get(result);
    if (before) return { ...state, result: before };
    const { vertices, faces } = await wholeModel(this.model, jobOf(wishes), signal);
    const original = { vertices: Float64Array.from(vertices, (at) => result.scale * at), faces };
    const lit = { ...result, original };
    this.known.set(result, lit);
    return { ...state, result: lit };
  }

  /** The same result, with that surface if it was fetched. */
  asShown(result: TimedResult): TimedResult {
    return this.known.get(result) ?? result;
  }
}
