/** The threads of a batch: as many models at a time. */
import { Worker } from 'node:worker_threads';
import type { Told } from '../exit.js';
import type { ModelEvent } from './batch-events.js';
import type { ListedModel } from './list-models.js';
import type { SlotAnswer, SlotData, SlotOrder, SlotOutcome } from './slot-protocol.js';

/** What is told of models; one of them may follow another at once. */
export interface SlotsListener {
  onBegin: (model: ListedModel) => void;
  onEvent: (model: ListedModel, event: ModelEvent) => void;
  onOutcome: (model: ListedModel, outcome: SlotOutcome) => void;
  /** The thread is gone, and has taken the model with it. */
  onDeath: (model: ListedModel, reason: Told) => void;
}

/** The model that a thread is at, and who waits for it. */
interface Turn {
  model: ListedModel;
  resolve: () => void;
  reject: (error: unknown) => void;
}

/** A thread; it starts anew for the next model when it has died. */
class Slot {
  private worker: Worker | null = null;
  private turn: Turn | null = null;

  constructor(
    private readonly data: SlotData,
    private readonly listener: SlotsListener,
  ) {}

  /** Ends when the model has an outcome, or has cost the thread its life. */
  do(model: ListedModel): Promise<void> {
    this.worker ??= this.start();
    this.listener.onBegin(model);
    this.worker.postMessage(model satisfies SlotOrder);
    return new Promise((resolve, reject) => (this.turn = { model, resolve, reject }));
  }

  async close(): Promise<void> {
    this.turn = null;
    await this.worker?.terminate();
  }

  private start(): Worker {
    const worker = new Worker(new URL('./batch-slot.js', import.meta.url), {
      workerData: this.data,
    });
    const die = (reason: Told): void => {
      this.worker = null;
      this.end(({ model }) => this.listener.onDeath(model, reason));
    };
    worker.on('message', (answer: SlotAnswer) => {
      if (answer.type === 'outcome') {
        this.end(({ model }) => this.listener.onOutcome(model, answer.outcome));
      } else if (this.turn) this.listener.onEvent(this.turn.model, answer.event);
    });
    worker.on('error', (error) => die(() => error.message));
    worker.on('exit', (status) => die(({ batch }) => batch.ended(status)));
    return worker;
  }

  private end(tell: (turn: Turn) => void): void {
    const { turn } = this;
    if (!turn) return;
    this.turn = null;
    // What a listener throws, such as a full disk, is for whoever waits.
    try {
      tell(turn);
      turn.resolve();
    } catch (error) {
      turn.reject(error);
    }
  }
}

/**
 * Does models, several at a time, in their order, until all are done or `signal` ends it.
 *
 * With fewer models than threads each gets several engine workers. Else one engine a model is faster: what
 * engines of one model wait for each other, and what only one of them can do, takes no core from another model.
 *
 * @param threads cores to be used
 */
export async function doModels(
  models: readonly ListedModel[],
  { commands, threads }: Pick<SlotData, 'commands'> & { threads: number },
  { listener, signal }: { listener: SlotsListener; signal: AbortSignal },
): Promise<void> {
  const count = Math.max(1, Math.min(threads, models.length));
  const data = { commands, workers: Math.max(1, Math.floor(threads / count)) };
  const slots = Array.from({ length: count }, () => new Slot(data, listener));
  const waiting = models.values();
  const ended = new Promise<void>((resolve) => signal.addEventListener('abort', () => resolve()));
  const work = slots.map(async (slot) => {
    // All slots take from the same list.
    for (const model of waiting) {
      if (signal.aborted) return;
      await slot.do(model);
    }
  });
  try {
    await Promise.race([Promise.all(work), ended]);
  } finally {
    await Promise.all(slots.map((slot) => slot.close()));
  }
}
