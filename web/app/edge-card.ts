import type { EdgeAction } from '../model/edge-edits.js';
import type { StudioPlace } from './place.js';
import { onPress } from './press.js';
import { SheetCard } from './sheet-card.js';

/** What the card says and offers. */
export interface EdgeCardContent {
  words: string;
  /** What can be done. */
  actions: readonly EdgeAction[];
  /** Whether that has to wait. */
  busy: boolean;
  /** What came of the last change, or why it was not made. */
  outcome: string;
}

export interface EdgeCardListener {
  act(action: EdgeAction): void;
  close(): void;
}

/** The card of the edge that is chosen. */
export class EdgeCard extends SheetCard {
  private readonly words = this.find('#edge-words', HTMLElement);
  private readonly outcome = this.find('#edge-outcome', HTMLElement);
  private readonly buttons: readonly HTMLButtonElement[];

  constructor(place: StudioPlace, listener: EdgeCardListener) {
    super(place, '#edge-card');
    this.buttons = [...this.card.querySelectorAll<HTMLButtonElement>('[data-action]')];
    for (const button of this.buttons) {
      onPress(button, () => listener.act(button.dataset['action'] as EdgeAction));
    }
    this.find('#edge-close', HTMLButtonElement).addEventListener('click', () => listener.close());
  }

  /** Shows an edge, or nothing. */
  show(content: EdgeCardContent | null): void {
    this.card.hidden = content === null;
    if (!content) return;
    this.change(() => {
      this.words.textContent = content.words;
      this.outcome.textContent = content.outcome;
      for (const button of this.buttons) {
        button.hidden = !content.actions.includes(button.dataset['action'] as EdgeAction);
        button.setAttribute('aria-disabled', String(content.busy));
      }
    });
  }
}
