import type { JobEvent } from '../model/job.js';
import { EventThrottle } from './event-throttle.js';
import type { Job, MainModule } from './generated/foldwright.mjs';
import type { Answer, Request, RunRequest, TimedEvent } from './protocol.js';
import { StageClock } from './stage-clock.js';
import { nextBudget } from './step-budget.js';
import { buffersOf } from './transfer.js';

/** What the worker needs of the engine's module. Its jobs never throw: failures come as events. */
export type Engine = Pick<MainModule, 'createJob'>;

/** What a worker differs in between browsers and node. */
export interface WorkerHost {
  loadEngine(): Promise<Engine>;
  post(answer: Answer, transfer: ArrayBuffer[]): void;
  /** Resolves after the messages that are waiting have been delivered. */
  pause(): Promise<void>;
}

const isLast = ({ type }: JobEvent): boolean => type === 'done' || type === 'error';

/** Adds the time to an event. */
function timed(event: JobEvent, clock: StageClock, now: number): TimedEvent {
  if (event.type === 'stage') return { ...event, seconds: clock.elapsed(now) };
  return event.type === 'done' ? { ...event, seconds: clock.seconds() } : event;
}

/** Steps one job to its end; true unless `isCancelled` ended it before. */
async function runToEnd(
  job: Job,
  host: WorkerHost,
  isCancelled: () => boolean,
  send: (event: TimedEvent) => void,
): Promise<boolean> {
  const throttle = new EventThrottle(send);
  const clock = new StageClock(performance.now());
  let budget = 1000;
  for (;;) {
    const before = performance.now();
    const events = job.step(budget);
    const now = performance.now();
    budget = nextBudget(budget, now - before);
    // A step works for one stage and names it, but for the step that finishes a stage.
    clock.spend(now, events.find((event) => event.type === 'stage')?.stage);
    for (const event of events) {
      if (isLast(event)) throttle.flush();
      throttle.push(timed(event, clock, now));
      if (isLast(event)) return true;
    }
    throttle.release(now);
    await host.pause();
    if (isCancelled()) return false;
  }
}

/**
 * Answers requests with the engine of this worker; give it every message that arrives. Whatever
 * throws in here leaves the engine in an unknown state and so ends the worker with an uncaught
 * error, which is how the other side learns of it.
 */
export function serveEngine(host: WorkerHost): (request: Request) => void {
  const engine = host.loadEngine();
  const running = new Set<number>();

  async function run({ job, bytes, fileName, options }: RunRequest): Promise<void> {
    const send = (event: TimedEvent): void => {
      host.post({ type: 'event', job, event }, buffersOf(event));
    };
    running.add(job);
    // The declarations allow for no job because it crosses the boundary as a pointer.
    const engineJob = (await engine).createJob(bytes, fileName, options)!;
    const finished = await runToEnd(engineJob, host, () => !running.has(job), send);
    engineJob.delete();
    if (!finished) host.post({ type: 'cancelled', job }, []);
    running.delete(job);
  }

  return (request) => {
    if (request.type === 'cancel') {
      running.delete(request.job);
      return;
    }
    run(request).catch((error: unknown) => {
      // A rejected promise alone does not reach the owner of a browser's worker.
      queueMicrotask(() => {
        throw error;
      });
    });
  };
}
