import type { EngineEvent } from '../model/job.js';
import type { Engine, WorkerHost } from './engine.js';
import { EventThrottle } from './event-throttle.js';
import type { Job } from './generated/foldwright.mjs';
import { DraftPace } from './draft-pace.js';
import { GenerationFilter } from './generation-filter.js';
import { engineDied } from './job-error.js';
import type {
  HelperRequest,
  LostRequest,
  ReportRequest,
  RunRequest,
  TaskOrder,
  TaskReport,
  TimedEngineEvent,
} from './protocol.js';
import { StageClock } from './stage-clock.js';
import { TaskExecutor } from './task-executor.js';
import { TaskDispatcher, type OpenTask } from './task-dispatcher.js';
import { buffersOf } from './transfer.js';

/** What reaches a conductor while its job runs. */
export type ConductorRequest = HelperRequest | LostRequest | ReportRequest;

/** Reports of all workers together, per second: what the eye can follow, and costs little. */
const reportsPerSecond = 8;

/** Helpers that may die over a task. More than one, because a system short of memory ends any. */
const mostDeaths = 3;

const isLast = ({ type }: EngineEvent): boolean => type === 'done' || type === 'error';

/** Adds the time to an event. */
function timed(event: EngineEvent, clock: StageClock, now: number): TimedEngineEvent {
  if (event.type === 'stage') return { ...event, seconds: clock.elapsed(now) };
  if (event.type !== 'done' && event.type !== 'cancelled') return event;
  return { ...event, seconds: clock.seconds() };
}

/** Runs one job: does the work that cannot be split, and its share of the tasks. */
export class Conductor {
  private readonly job: Job;
  private readonly executor: TaskExecutor;
  private readonly dispatcher = new TaskDispatcher();
  private readonly filter = new GenerationFilter();
  private readonly drafts: DraftPace | null;
  private readonly clock = new StageClock(performance.now());
  private readonly throttle: EventThrottle;
  private helpersAsked = 0;
  private finished = false;
  private ended = false;
  private running: Promise<void> = Promise.resolve();
  private wake: () => void = () => undefined;

  constructor(
    engine: Engine,
    private readonly host: WorkerHost,
    private readonly request: RunRequest,
  ) {
    const { files, options, start } = request;
    // The declarations allow for no job because it crosses the boundary as a pointer.
    this.job = engine.createJob(files, options, start)!;
    this.executor = new TaskExecutor(engine);
    this.drafts = request.drafts ? new DraftPace() : null;
    this.throttle = new EventThrottle((events) => {
      host.post({ type: 'events', job: this.number, events }, buffersOf(events));
    });
  }

  /** Of the job. */
  get number(): number {
    return this.request.job;
  }

  /** Runs the job to its end and frees everything; rejects if the engine fails. */
  run(): Promise<void> {
    this.running = this.runNow();
    return this.running;
  }

  /** Frees everything at the next pause. */
  end(): Promise<void> {
    this.ended = true;
    this.wake();
    return this.running;
  }

  /** Takes in what happens among the helpers. */
  take(request: ConductorRequest): void {
    if (this.finished || this.ended) return;
    if (request.type === 'helper') this.dispatcher.join(request.helper);
    if (request.type === 'lost') this.lose(request);
    if (request.type === 'report') this.receive(request);
    this.wake();
  }

  private receive({ helper, report }: ReportRequest): void {
    if (!this.dispatcher.isOut(helper, report.task)) return;
    if (report.result) {
      this.dispatcher.finish(helper);
      // The helper has its next task before its result is looked at, which takes a while.
      this.handOut();
    }
    this.handle(report);
  }

  private async runNow(): Promise<void> {
    while (!this.finished && !this.ended) {
      const idle = !this.work();
      this.handOut();
      if (this.finished) break;
      this.throttle.release(performance.now());
      await (idle ? this.message() : this.host.pause());
    }
    this.executor.close();
    if (!this.finished) this.leave();
    this.job.delete();
  }

  /** Ends the job before its time and tells what it has come to. */
  private leave(): void {
    const events = this.job.cancel().map((event) => timed(event, this.clock, performance.now()));
    this.host.post({ type: 'events', job: this.number, events }, buffersOf(events));
  }

  /** Does some milliseconds of work; false when everything waits for the helpers. */
  private work(): boolean {
    if (this.drafts?.isDue(performance.now())) this.makeDraft(this.drafts);
    if (this.executor.busy) {
      const report = this.executor.step();
      if (report) this.handle(report);
      // Tasks that take but a moment are done sooner than a worker is started.
      else this.askForHelp();
      return true;
    }
    const task = this.dispatcher.takeOwn();
    if (task) this.begin(task);
    else if (this.dispatcher.outCount + this.dispatcher.waitingCount === 0)
      this.passOnEvents(this.job.advance());
    else return false;
    return true;
  }

  private makeDraft(pace: DraftPace): void {
    const from = performance.now();
    this.passOnEvents(this.job.draft());
    pace.made(from, performance.now());
  }

  /** The job and its own tasks share one copy of a surface. */
  private begin(task: OpenTask): void {
    const { surface } = task;
    if (!this.executor.has(surface)) this.executor.keep(surface, this.job.surface(surface)!);
    this.executor.begin(this.orderFor(task, false));
  }

  private handle({ task, status, result, foldingTime }: TaskReport): void {
    // Workers are at it at the same time: it is shared out, so that no more comes of it than the stages took.
    this.clock.fold(foldingTime / (1 + this.dispatcher.helperCount));
    this.passOnEvents(this.filter.newOf(task, this.job.report(task, status)));
    if (result && !this.finished) this.passOnEvents(this.job.complete(task, result));
  }

  private lose({ helper, reason }: LostRequest): void {
    const task = this.dispatcher.leave(helper);
    if (!task) return;
    this.filter.restart(task.id);
    if (task.deaths < mostDeaths) return;
    this.passOnEvents([{ type: 'error', code: engineDied, params: { reason, times: mostDeaths } }]);
  }

  /** Passes events on, and puts the tasks that have come up in its queue. */
  private passOnEvents(events: EngineEvent[]): void {
    const now = performance.now();
    // What happens belongs to one stage and names it, but for the step that finishes a stage.
    this.clock.spend(now, events.find((event) => event.type === 'stage')?.stage);
    this.drafts?.follow(events);
    for (const event of events) this.throttle.push(timed(event, this.clock, now));
    if (events.some(isLast)) {
      this.finished = true;
      this.throttle.flush();
      return;
    }
    let hasTasks = false;
    for (let task = this.job.takeTask(); task; task = this.job.takeTask()) {
      this.dispatcher.add(task.id, task.surface, task.bytes);
      hasTasks = true;
    }
    // With its first net or task the search has taken over the nets that there are; before that there is no work to share.
    const hasBegun = hasTasks || events.some(({ type }) => type === 'net');
    if (hasBegun && !this.request.searches) this.ended = true;
  }

  private orderFor({ id, surface, bytes }: OpenTask, withSurface: boolean): TaskOrder {
    const { helpers, pictures } = this.request;
    return {
      task: id,
      bytes,
      surface,
      surfaceBytes: withSurface ? this.job.surfaceBytes(surface) : null,
      interval: (1000 * (1 + helpers)) / reportsPerSecond,
      pictures,
    };
  }

  /** Gives what waits to the helpers that stand by. */
  private handOut(): void {
    if (this.finished) return;
    for (let next = this.dispatcher.assign(); next; next = this.dispatcher.assign()) {
      const order = this.orderFor(next.task, next.needsSurface);
      // The task's own bytes are copied: a helper that dies takes its copy along.
      const transfer = buffersOf(order.surfaceBytes);
      const { helper } = next;
      this.host.post({ type: 'task', job: this.number, helper, order }, transfer);
    }
  }

  private askForHelp(): void {
    const wanted = Math.min(
      this.dispatcher.waitingCount + this.dispatcher.outCount,
      this.request.helpers,
    );
    if (wanted <= this.helpersAsked) return;
    this.helpersAsked = wanted;
    this.host.post({ type: 'help', job: this.number, wanted }, []);
  }

  private message(): Promise<void> {
    return new Promise((resolve) => {
      this.wake = resolve;
    });
  }
}
