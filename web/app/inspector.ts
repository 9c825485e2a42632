import { JobError } from '../core/job-error.js';
import { Check } from './check.js';
import { failureOf, type Ending } from './ending.js';
import type { ChosenModel } from './model-file.js';
import type { OpenLooker, Wishes } from './quick-looks.js';
import type { OpenModel, StoreNeeds } from './store-needs.js';

/** Looks at chosen models, and keeps what was read for the run that follows. */
export class Inspector {
  private present: Check | null = null;
  /** Has read the model that was looked at; null once a run has it. */
  private readSession: OpenModel | null = null;

  /** @param onChange is called when there is something else to be seen of the model */
  constructor(
    private readonly needs: Pick<StoreNeeds, 'open'>,
    private readonly onChange: () => void,
  ) {}

  /** The model that was looked at last; null while another one is read. */
  get check(): Check | null {
    return this.present;
  }

  /** Another model was chosen, at which nobody has looked. */
  forget(): void {
    this.present = this.readSession = null;
  }

  /** Looks at a model as it is. A file that is none leaves the model before, whose choice comes back. */
  async inspect(model: ChosenModel, wishes: Wishes, signal: AbortSignal): Promise<Ending> {
    const before = this.present;
    this.present = null;
    const ending = await this.inspectNow(model, wishes, signal);
    const isNone = ending.type === 'failed' && ending.cause === 'file';
    if (isNone && !signal.aborted) this.present = before;
    return ending;
  }

  /** The session that has read a model already, or another one. */
  open({ files }: ChosenModel): Promise<OpenModel> {
    const { readSession, present } = this;
    this.readSession = null;
    const isRead = readSession && present?.model.files === files;
    return isRead ? Promise.resolve(readSession) : this.needs.open(files);
  }

  private async inspectNow(
    model: ChosenModel,
    wishes: Wishes,
    signal: AbortSignal,
  ): Promise<Ending> {
    try {
      const session = await this.needs.open(model.files);
      const open: OpenLooker = (files) => this.needs.open(files);
      const check = new Check(model, session, open, this.onChange);
      await check.begin(wishes, signal);
      signal.throwIfAborted();
      [this.present, this.readSession] = [check, session];
      return { type: 'inspected', check };
    } catch (error) {
      if (signal.aborted) return { type: 'cancelled' };
      if (!(error instanceof JobError)) throw error;
      return failureOf(error, false);
    }
  }
}
