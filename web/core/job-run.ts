import type { Pool, PoolListener } from './pool.js';
import type { Answer, EventsAnswer, RunRequest, TimedEngineEvent } from './protocol.js';
import { englishPhrase } from '../words/phrase.js';
import { buffersOf } from './transfer.js';

/** What a run tells whoever started it. */
export interface RunListener {
  onEvent(event: TimedEngineEvent): void;
  /** The conductor is gone, and the job with it; `reason` is for people. */
  onDeath(reason: string): void;
}

/**
 * How long workers may take to answer when a run ends, unless said otherwise. In ms: less than the
 * 100 that people take for at once, which the page needs some of.
 */
export const defaultPatience = 80;

/**
 * How long a conductor may take to hand its nets over to whoever wants them, in ms. Laying the nets of the
 * largest models on sheets in a hurry takes some seconds, and they took minutes to find.
 */
const patienceForNets = 30_000;

/** What a conductor tells last of a job that nobody has ended. */
const lastTypes: ReadonlySet<string> = new Set<TimedEngineEvent['type']>([
  'done',
  'error',
  'cancelled',
]);

/** An event with its message in English. */
function inWords(event: TimedEngineEvent): TimedEngineEvent {
  const hasMessage = event.type === 'notice' || event.type === 'error';
  return hasMessage ? { ...event, text: englishPhrase(event) } : event;
}

/**
 * One job on its way through the workers of a pool, as the main thread sees it: passes messages on
 * between the conductor and its helpers, and replaces helpers that die.
 */
export class JobRun implements PoolListener {
  private readonly job: number;
  private conductor: number;
  /**
   * Whether the conductor was there before the job and has told nothing of it so far. Such a worker
   * may have failed when it was started ahead, which costs the job nothing: a new one takes over.
   */
  private unheard: boolean;
  private readonly helpers = new Set<number>();
  /** Workers that hold something of the job. */
  private readonly engaged = new Set<number>();
  private whenEnded: (() => void) | null = null;
  /** Whether the conductor has told of a net, which is worth waiting for. */
  private hasNets = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /**
   * Starts the job; needs its turn in the pool. At its end, workers that have not answered for
   * `patience` ms are in a long step, and replaced.
   */
  constructor(
    private readonly pool: Pool,
    private readonly request: Omit<RunRequest, 'type' | 'helpers'>,
    private readonly listener: RunListener,
    private readonly patience = defaultPatience,
  ) {
    this.job = request.job;
    pool.listen(this);
    const [first] = pool.workers;
    this.unheard = first !== undefined;
    this.conductor = first ?? pool.start();
    this.conduct();
  }

  /**
   * Frees what all workers hold of the job and then calls `whenEnded`, within the patience that there
   * is: who does not answer by then is thrown away. With `waitsForNets`, a conductor that has nets gets
   * as long as it takes to hand them over. A second call can only shorten the wait of the first.
   */
  end(whenEnded: () => void, waitsForNets = false): void {
    if (!this.whenEnded) {
      this.whenEnded = whenEnded;
      for (const worker of this.engaged) this.pool.post(worker, { type: 'end', job: this.job });
    } else if (waitsForNets) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      const isAwaited = waitsForNets && this.hasNets && this.engaged.has(this.conductor);
      for (const helper of this.engaged) {
        if (!isAwaited || helper !== this.conductor) this.throwAway(helper);
      }
      if (isAwaited) this.timer = setTimeout(() => this.throwAway(this.conductor), patienceForNets);
    }, this.patience);
    this.settleIfFree();
  }

  private throwAway(worker: number): void {
    this.pool.discard(worker);
    this.free(worker);
  }

  onAnswer(worker: number, answer: Answer): void {
    if (answer.job !== this.job) return;
    if (worker === this.conductor) this.unheard = false;
    if (answer.type === 'ended') this.free(worker);
    if (!this.whenEnded) this.passOn(worker, answer);
    // What is still under way when the job ends is of no use any more, but for what it came to.
    else if (answer.type === 'events') this.passOnLast(answer.events);
  }

  onDeath(worker: number, reason: string): void {
    const wasEngaged = this.engaged.has(worker);
    this.helpers.delete(worker);
    this.free(worker);
    if (this.whenEnded) return;
    if (worker === this.conductor) {
      if (!this.unheard) return this.listener.onDeath(reason);
      this.unheard = false;
      this.conductor = this.pool.start();
      return this.conduct();
    }
    this.pool.post(this.conductor, { type: 'lost', job: this.job, helper: worker, reason });
    // One that died before it had anything to do would be followed by others like it, for ever.
    if (wasEngaged) this.enlist(this.pool.start());
  }

  onClose(): void {
    this.engaged.clear();
    if (this.whenEnded) this.settleIfFree();
    else this.listener.onDeath('its workers were closed');
  }

  /** Hands the job to the conductor, and all other workers that are there to it. */
  private conduct(): void {
    const { conductor, pool } = this;
    this.engaged.add(conductor);
    pool.post(conductor, { ...this.request, type: 'run', helpers: pool.size - 1 });
    for (const worker of pool.workers) if (worker !== conductor) this.enlist(worker);
  }

  private passOn(worker: number, answer: Answer): void {
    const { job } = this;
    if (answer.type === 'events') this.passOnEvents(answer);
    if (answer.type === 'help') {
      while (this.helpers.size < answer.wanted) this.enlist(this.pool.start());
    }
    if (answer.type === 'task') {
      const { helper, order } = answer;
      if (this.helpers.has(helper)) this.engaged.add(helper);
      this.pool.post(helper, { type: 'task', job, order }, buffersOf(order));
    }
    if (answer.type === 'report') {
      const { report } = answer;
      const transfer = buffersOf(report);
      this.pool.post(this.conductor, { type: 'report', job, helper: worker, report }, transfer);
    }
  }

  private passOnEvents({ events }: EventsAnswer): void {
    for (const [index, event] of events.entries()) {
      // Whoever hears an event may end the job.
      if (this.whenEnded) return this.passOnLast(events.slice(index));
      // After the last event the conductor frees everything by itself.
      if (lastTypes.has(event.type)) this.engaged.delete(this.conductor);
      if (event.type === 'net') this.hasNets = true;
      this.listener.onEvent(inWords(event));
    }
  }

  /** What the job came to after its end was asked for: its nets so far, or all of them. */
  private passOnLast(events: readonly TimedEngineEvent[]): void {
    for (const event of events) {
      if (event.type === 'cancelled') this.listener.onEvent(event);
      if (event.type !== 'done') continue;
      const { result: best, seconds } = event;
      this.listener.onEvent({ type: 'cancelled', best, seconds });
      // It frees everything by itself.
      this.free(this.conductor);
    }
  }

  private enlist(worker: number): void {
    this.helpers.add(worker);
    this.pool.post(this.conductor, { type: 'helper', job: this.job, helper: worker });
  }

  private free(worker: number): void {
    this.engaged.delete(worker);
    if (this.whenEnded) this.settleIfFree();
  }

  private settleIfFree(): void {
    if (this.engaged.size > 0) return;
    clearTimeout(this.timer);
    const { whenEnded } = this;
    this.whenEnded = () => undefined;
    whenEnded?.();
  }
}
