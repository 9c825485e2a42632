/** A look at a model before it is unfolded. */
import type { TimedEvent } from '../core/protocol.js';
import { componentsOf, type Component } from '../model/components.js';
import type { JobOptions } from '../model/job-options.js';
import type { Message } from '../model/message.js';
import type { OpenedModel } from './opened-model.js';

/** What a model turns out to be. */
export interface Inspection {
  /** Name of the file that is the model. */
  file: string;
  /** Repaired, and simplified if that was asked for; in units of the file, y is up. */
  model: {
    /** 3 per vertex. */
    vertices: Float32Array;
    /** 3 per face, counter-clockwise from outside. */
    faces: Int32Array;
  };
  /** What was repaired and what cannot be, as messages. */
  repairs: readonly Message[];
  /** Its separate bodies. */
  components: readonly Component[];
  /** Per face: the component that it belongs to, from 0. */
  componentOfFaces: Int32Array;
  /** Pieces of the nets that the file brings along; 0 if it has none. */
  fileNets: number;
}

type ModelEvent = Extract<TimedEvent, { type: 'model' }>;

/** Gives way to whoever waits after some milliseconds of work, and ends with the signal. */
function pauses(signal: AbortSignal | undefined): () => Promise<void> {
  const most = 8;
  let since = performance.now();
  return async () => {
    signal?.throwIfAborted();
    if (performance.now() - since < most) return;
    await new Promise((resolve) => setTimeout(resolve));
    since = performance.now();
  };
}

/** What a job tells of a model before all else. */
interface ToldModel {
  event: ModelEvent;
  repairs: Message[];
}

async function inspectionOf(
  opened: OpenedModel,
  { event: { file, vertices, faces }, repairs }: ToldModel,
  signal: AbortSignal | undefined,
): Promise<Inspection> {
  const { components, ofFaces } = await componentsOf(vertices, faces, pauses(signal));
  const nets = await opened.fileNets(signal);
  return {
    file,
    model: { vertices, faces },
    repairs,
    components,
    componentOfFaces: ofFaces,
    fileNets: nets?.pieces.length ?? 0,
  };
}

/** Reads, repairs and simplifies a model as a run would: with a job that is ended as soon as it has told of the model. */
function toldModel(
  opened: OpenedModel,
  options: JobOptions,
  signal: AbortSignal | undefined,
): Promise<ToldModel> {
  const end = new AbortController();
  const stop = (): void => end.abort(signal?.reason);
  signal?.throwIfAborted();
  signal?.addEventListener('abort', stop, { once: true });
  return new Promise<ToldModel>((resolve, reject) => {
    const repairs: Message[] = [];
    const onEvent = (event: TimedEvent): void => {
      if (end.signal.aborted) return;
      if (event.type === 'notice') repairs.push({ code: event.code, params: event.params });
      if (event.type !== 'model') return;
      // Repairs are told before the model, and nothing else is wanted of the job.
      resolve({ event, repairs });
      end.abort();
    };
    // After the model was told the rejection is that of the end, and nobody hears it.
    opened.run(options, { signal: end.signal, onEvent }).catch(reject);
  }).finally(() => signal?.removeEventListener('abort', stop));
}

/**
 * Reads, repairs and simplifies a model as a run with these options would. The workers are free again shortly
 * afterwards.
 *
 * Rejects with a `JobError` for a model that cannot be read or used, and with the signal's reason at once after an
 * abort.
 */
export async function inspectModel(
  opened: OpenedModel,
  options: JobOptions,
  signal?: AbortSignal,
): Promise<Inspection> {
  return inspectionOf(opened, await toldModel(opened, options, signal), signal);
}

/** The model as a run with these options has it before it is simplified; in units of the file, y is up. */
export async function wholeModel(
  opened: OpenedModel,
  options: JobOptions,
  signal?: AbortSignal,
): Promise<Inspection['model']> {
  const { event } = await toldModel(opened, { ...options, faces: 0 }, signal);
  return { vertices: event.vertices, faces: event.faces };
}
