import type { Engine } from './engine.js';
import type { Surface, Task } from './generated/foldwright.mjs';
import type { TaskOrder, TaskReport } from './protocol.js';
import { nextBudget } from './step-budget.js';

/** Runs the tasks of one job with one instance of the engine, one after the other, in steps. */
export class TaskExecutor {
  private readonly surfaces = new Map<number, Surface>();
  private order: TaskOrder | null = null;
  private task: Task | null = null;
  private budget = 1000;
  private lastReport = -Infinity;
  /** Milliseconds of the task that went into how nets fold, since its last report. */
  private foldingTime = 0;

  constructor(private readonly engine: Engine) {}

  /** Whether a task is under way. */
  get busy(): boolean {
    return this.task !== null;
  }

  /** Whether this surface is there, so that an order need not bring it. */
  has(surface: number): boolean {
    return this.surfaces.has(surface);
  }

  /** Keeps a surface for orders to come, until the end. */
  keep(number: number, surface: Surface): void {
    this.surfaces.set(number, surface);
  }

  begin(order: TaskOrder): void {
    const { surface, surfaceBytes, bytes } = order;
    // The declarations allow for null because these cross the boundary as pointers.
    if (surfaceBytes) this.keep(surface, this.engine.createSurface(surfaceBytes)!);
    this.task = this.engine.createTask(this.surfaces.get(surface)!, bytes)!;
    this.order = order;
  }

  /** Works on the task for some milliseconds; what it tells when it is time for that, or done. */
  step(): TaskReport | null {
    const { order, task } = this;
    if (!order || !task) return null;
    const isFolding = task.isFolding();
    const before = performance.now();
    const done = task.step(this.budget);
    const now = performance.now();
    if (isFolding) this.foldingTime += now - before;
    this.budget = nextBudget(this.budget, now - before);
    const due = now - this.lastReport >= order.interval;
    if (!done && !due) return null;
    if (due) this.lastReport = now;
    // What a search comes to is seen, however little time it took.
    const status = task.status(order.pictures && (due || done));
    const result = done ? task.result() : null;
    const { foldingTime } = this;
    this.foldingTime = 0;
    if (done) this.drop();
    return { task: order.task, status, result, foldingTime };
  }

  /** Frees everything. */
  close(): void {
    this.drop();
    for (const surface of this.surfaces.values()) surface.delete();
    this.surfaces.clear();
  }

  private drop(): void {
    this.task?.delete();
    this.task = null;
    this.order = null;
  }
}
