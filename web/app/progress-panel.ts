import type { TimedEvent } from '../core/protocol.js';
import { isForField } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { ProgressWords } from './progress-words.js';

/** Where progress is shown; `isQuiet`: nothing is scrolled for it. */
export interface ProgressPlace {
  host: HTMLElement;
  isQuiet?: boolean;
}

/** What ends the work. */
export interface ProgressListener {
  /** All goes back to what was before. */
  cancel(): void;
  /** What is there is taken. */
  stop(): void;
}

/** The card that tells how far a run is, with the buttons that end it. */
export class ProgressPanel extends Panel {
  private readonly card = this.find('#progress', HTMLElement);
  private readonly model = this.find('#progress-model', HTMLElement);
  private readonly words = this.find('#progress-words', HTMLElement);
  private readonly bar = this.find('#progress-bar', HTMLProgressElement);
  private readonly percent = this.find('#progress-percent', HTMLElement);
  private readonly announcement = this.find('#announcement', HTMLElement);
  private readonly left = this.find('#progress-left', HTMLElement);
  private readonly cancel = this.find('#cancel', HTMLButtonElement);
  private readonly stop = this.find('#stop', HTMLButtonElement);
  private state = new ProgressWords(this.told);
  /** Whether there is work to be seen. */
  private isOpen = false;
  /** Whether it is being ended: what it tells then is of no use any more. */
  private isLeaving = false;

  constructor(place: StudioPlace, listener: ProgressListener) {
    super(place);
    const cancel = (): void => {
      this.leave(this.told.run.goingBack);
      listener.cancel();
    };
    this.cancel.addEventListener('click', cancel);
    this.stop.addEventListener('click', () => {
      this.leave(this.told.run.stopping);
      // The button goes with the press, and the keyboard would go with it.
      this.cancel.focus();
      listener.stop();
    });
    const press = (event: Event): void => {
      const isEscape = event instanceof KeyboardEvent && event.key === 'Escape';
      // In a field it closes a list, or takes back what was written.
      if (isEscape && this.isOpen && !isForField(event)) cancel();
    };
    place.ground.addEventListener('keydown', press, { signal: place.life });
  }

  /** Whether the keyboard is on the card, which is about to go. */
  get hasFocus(): boolean {
    return this.card.matches(':focus-within');
  }

  /** Whether what is there can be taken. */
  set canStop(canStop: boolean) {
    this.stop.hidden = !canStop;
  }

  /** Starts anew with work that is not to be seen yet. */
  prepare(): void {
    this.state = new ProgressWords(this.told);
  }

  /** Shows what goes on with a model, in another place than its own what has gone on since `prepare`. */
  begin(modelName: string, place?: ProgressPlace): void {
    if (place) place.host.append(this.card);
    else {
      this.announcement.before(this.card);
      this.prepare();
    }
    this.model.textContent = modelName;
    this.isOpen = true;
    this.isLeaving = false;
    this.card.hidden = false;
    this.show();
    if (place?.isQuiet !== true) this.card.scrollIntoView({ block: 'nearest' });
  }

  /** Takes an event of the run in. */
  follow(event: TimedEvent): void {
    this.state.follow(event);
    if (!this.isLeaving) this.show();
  }

  /** Puts the card away and says how it ended. */
  end(words: string): void {
    this.isOpen = false;
    this.card.hidden = true;
    this.announcement.textContent = words;
  }

  private leave(words: string): void {
    this.isLeaving = true;
    this.words.textContent = words;
    this.left.textContent = '';
  }

  private show(): void {
    const { headline, left, progress, text } = this.state;
    this.words.textContent = text;
    this.left.textContent = left;
    this.bar.value = progress;
    this.percent.textContent = this.told.result.percent(Math.floor(100 * progress));
    // Only what is new is spoken: setting the same words again may repeat them.
    if (this.announcement.textContent !== headline) this.announcement.textContent = headline;
  }
}
