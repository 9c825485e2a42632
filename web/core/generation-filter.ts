import type { EngineEvent } from '../model/job.js';

/**
 * Keeps a job from telling generations twice. A task whose helper died is run again from its start
 * and tells the same generations once more; the job does not know that, and counts on.
 */
export class GenerationFilter {
  /** By task: how many it has told. */
  private readonly told = new Map<number, number>();
  /** By task: how many of the next ones are known. */
  private readonly known = new Map<number, number>();
  /** By part: how many the job has counted too much. */
  private readonly surplus = new Map<number, number>();

  /** The task is run again. */
  restart(task: number): void {
    this.known.set(task, this.told.get(task) ?? 0);
  }

  /** What is new of what has happened in a task, with the numbers that it would have had. */
  newOf(task: number, events: EngineEvent[]): EngineEvent[] {
    return events.flatMap((event): EngineEvent[] => {
      if (event.type !== 'generation') return [event];
      const { part, generation } = event;
      const known = this.known.get(task) ?? 0;
      const surplus = this.surplus.get(part) ?? 0;
      if (known > 0) {
        this.known.set(task, known - 1);
        this.surplus.set(part, surplus + 1);
        return [];
      }
      this.told.set(task, (this.told.get(task) ?? 0) + 1);
      return [{ ...event, generation: generation - surplus }];
    });
  }
}
