/** A task that has no result yet. */
export interface OpenTask {
  id: number;
  surface: number;
  bytes: Uint8Array;
  /** Helpers that died over it. */
  deaths: number;
}

/** A task for a helper, which may need the surface as well. */
export interface Assignment {
  helper: number;
  task: OpenTask;
  needsSurface: boolean;
}

/**
 * Who runs which task of a job. Results do not depend on that: tasks go to whoever is free. A task
 * is kept until its result is there, so that a helper's death costs nothing but time.
 */
export class TaskDispatcher {
  private readonly waiting: OpenTask[] = [];
  private readonly out = new Map<number, OpenTask>();
  /** By helper, the surfaces that it has. */
  private readonly surfaces = new Map<number, Set<number>>();

  /** Helpers that stand by or have a task. */
  get helperCount(): number {
    return this.surfaces.size;
  }

  /** Tasks that nobody has taken. */
  get waitingCount(): number {
    return this.waiting.length;
  }

  /** Tasks that helpers have taken. */
  get outCount(): number {
    return this.out.size;
  }

  add(id: number, surface: number, bytes: Uint8Array): void {
    this.waiting.push({ id, surface, bytes, deaths: 0 });
  }

  /** A helper stands by for the first time. */
  join(helper: number): void {
    this.surfaces.set(helper, new Set());
  }

  /**
   * A task for the conductor. One that a helper died over is left to helpers as long as there are
   * any: the conductor's death would end the job.
   */
  takeOwn(): OpenTask | undefined {
    const alone = this.surfaces.size === 0;
    const index = this.waiting.findIndex(({ deaths }) => alone || deaths === 0);
    return index < 0 ? undefined : this.waiting.splice(index, 1)[0];
  }

  /** The next task for a helper, if one waits and a helper stands by. */
  assign(): Assignment | undefined {
    const helper = [...this.surfaces.keys()].find((each) => !this.out.has(each));
    if (helper === undefined) return undefined;
    const task = this.waiting.shift();
    if (!task) return undefined;
    this.out.set(helper, task);
    const has = this.surfaces.get(helper)!;
    const needsSurface = !has.has(task.surface);
    has.add(task.surface);
    return { helper, task, needsSurface };
  }

  /** Whether it is this task that the helper has. */
  isOut(helper: number, task: number): boolean {
    return this.out.get(helper)?.id === task;
  }

  /** The helper has finished its task and stands by. */
  finish(helper: number): void {
    this.out.delete(helper);
  }

  /** The helper died. Returns the task that it had, which waits again, before all others. */
  leave(helper: number): OpenTask | undefined {
    const task = this.out.get(helper);
    this.out.delete(helper);
    this.surfaces.delete(helper);
    if (!task) return undefined;
    ++task.deaths;
    this.waiting.unshift(task);
    return task;
  }
}
