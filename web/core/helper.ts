import type { Engine, WorkerHost } from './engine.js';
import type { TaskOrder } from './protocol.js';
import { TaskBench } from './task-bench.js';
import { buffersOf } from './transfer.js';

/** A worker's part in a job that another one conducts: runs tasks, one at a time. */
export class Helper {
  private readonly bench: TaskBench;
  private running: Promise<void> = Promise.resolve();
  private ended = false;

  /** @param number of the job */
  constructor(
    engine: Engine,
    private readonly host: WorkerHost,
    readonly number: number,
  ) {
    this.bench = new TaskBench(engine);
  }

  /** Runs a task to its end, once the one before has ended; rejects if the engine fails. */
  run(order: TaskOrder): Promise<void> {
    this.running = this.running.then(() => this.runNow(order));
    return this.running;
  }

  /** Frees everything at the next pause. */
  async end(): Promise<void> {
    this.ended = true;
    await this.running;
    this.bench.close();
  }

  private async runNow(order: TaskOrder): Promise<void> {
    if (this.ended) return;
    this.bench.begin(order);
    while (this.bench.busy && !this.ended) {
      const report = this.bench.step();
      if (report) this.host.post({ type: 'report', job: this.number, report }, buffersOf(report));
      await this.host.pause();
    }
  }
}
