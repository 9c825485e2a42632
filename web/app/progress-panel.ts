import type { JobEvent } from '../model/job.js';
import { isForField } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { ProgressWords } from './progress-words.js';

/** Where progress is shown; `isQuiet`: nothing is scrolled for it. */
export interface ProgressPlace {
  host: HTMLElement;
  isQuiet?: boolean;
}

/** The card that tells how far a run is, with the button that ends it. */
export class ProgressPanel extends Panel {
  private readonly card = this.find('#progress', HTMLElement);
  private readonly model = this.find('#progress-model', HTMLElement);
  private readonly words = this.find('#progress-words', HTMLElement);
  private readonly bar = this.find('#progress-bar', HTMLProgressElement);
  private readonly percent = this.find('#progress-percent', HTMLElement);
  private readonly announcement = this.find('#announcement', HTMLElement);
  private readonly cancel = this.find('#cancel', HTMLButtonElement);
  private state = new ProgressWords();
  /** Whether there is work to be seen. */
  private isOpen = false;

  constructor(place: StudioPlace, onCancel: () => void) {
    super(place);
    const stop = (): void => {
      this.words.textContent = 'Stopping. What is finished is kept.';
      onCancel();
    };
    this.cancel.addEventListener('click', stop);
    const press = (event: Event): void => {
      const isEscape = event instanceof KeyboardEvent && event.key === 'Escape';
      // In a field it closes a list, or takes back what was written.
      if (isEscape && this.isOpen && !isForField(event)) stop();
    };
    place.ground.addEventListener('keydown', press, { signal: place.life });
  }

  /** Whether the keyboard is on the card, which is about to go. */
  get hasFocus(): boolean {
    return this.card.matches(':focus-within');
  }

  /** Starts anew for a model, in its own place or in another one. */
  begin(modelName: string, place?: ProgressPlace): void {
    if (place) place.host.append(this.card);
    else this.announcement.before(this.card);
    this.state = new ProgressWords();
    this.model.textContent = modelName;
    this.isOpen = true;
    this.card.hidden = false;
    this.show();
    if (place?.isQuiet !== true) this.card.scrollIntoView({ block: 'nearest' });
  }

  /** Takes an event of the run in. */
  follow(event: JobEvent): void {
    this.state.follow(event);
    this.show();
  }

  /** Puts the card away and says how it ended. */
  end(words: string): void {
    this.isOpen = false;
    this.card.hidden = true;
    this.announcement.textContent = words;
  }

  private show(): void {
    const { headline, progress, text } = this.state;
    this.words.textContent = text;
    this.bar.value = progress;
    this.percent.textContent = `${Math.floor(100 * progress)} %`;
    // Only what is new is spoken: setting the same words again may repeat them.
    if (this.announcement.textContent !== headline) this.announcement.textContent = headline;
  }
}
