import type { Engine, WorkerHost } from './engine.js';
import type { TaskOrder } from './protocol.js';
import { TaskExecutor } from './task-executor.js';
import { buffersOf } from './transfer.js';

/** A worker's part in a job that another one conducts: runs tasks, one at a time. */
export class Helper {
  private readonly executor: TaskExecutor;
  private running: Promise<void> = Promise.resolve();
  private ended = false;

  /** @param number of the job */
  constructor(
    engine: Engine,
    private readonly host: WorkerHost,
    readonly number: number,
  ) {
    this.executor = new TaskExecutor(engine);
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
    this.executor.close();
  }

  private async runNow(order: TaskOrder): Promise<void> {
    if (this.ended) return;
    this.executor.begin(order);
    while (this.executor.busy && !this.ended) {
      const report = this.executor.step();
      if (report) this.host.post({ type: 'report', job: this.number, report }, buffersOf(report));
      await this.host.pause();
    }
  }
}
