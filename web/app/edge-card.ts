import type { EdgeAction } from '../model/edge-edits.js';
import type { StudioPlace } from './place.js';
import type { PlaceWalk } from './place-walk.js';
import { onPress } from './press.js';
import { SheetCard } from './sheet-card.js';

/** What the card says and offers. */
export interface EdgeCardContent {
  words: string;
  /** What can be done. */
  actions: readonly EdgeAction[];
  /** Whether that has to wait. */
  busy: boolean;
  /** What the button says that hands a face over. */
  gift: string;
  /** What came of the last change, or why it was not made. */
  outcome: string;
  /** What the walk through several places is about, and where it is; null outside of one. */
  walk: Pick<PlaceWalk, 'wordsIn' | 'isLong'> | null;
}

export interface EdgeCardListener {
  act(action: EdgeAction): void;
  /** Goes to the next place of a walk, or with -1 to the one before. */
  step(by: 1 | -1): void;
  close(): void;
}

/** The card of the edge that is chosen. */
export class EdgeCard extends SheetCard {
  private readonly words = this.find('#edge-words', HTMLElement);
  private readonly outcome = this.find('#edge-outcome', HTMLElement);
  private readonly gift = this.find('#edge-gift', HTMLButtonElement);
  private readonly walk = this.find('#edge-walk', HTMLElement);
  private readonly walkWords = this.find('#edge-walk-words', HTMLElement);
  private readonly walkButtons = [...this.walk.querySelectorAll<HTMLButtonElement>('[data-walk]')];
  private readonly buttons: readonly HTMLButtonElement[];

  constructor(place: StudioPlace, listener: EdgeCardListener) {
    super(place, '#edge-card');
    this.buttons = [...this.card.querySelectorAll<HTMLButtonElement>('[data-action]')];
    for (const button of this.buttons) {
      onPress(button, () => listener.act(button.dataset['action'] as EdgeAction));
    }
    for (const button of this.walkButtons) {
      button.addEventListener('click', () =>
        listener.step(button.dataset['walk'] === '1' ? 1 : -1),
      );
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
      this.gift.textContent = content.gift;
      this.walk.hidden = content.walk === null;
      this.walkWords.textContent = content.walk?.wordsIn(this.told) ?? '';
      for (const button of this.walkButtons) button.hidden = content.walk?.isLong !== true;
      for (const button of this.buttons) {
        button.hidden = !content.actions.includes(button.dataset['action'] as EdgeAction);
        button.setAttribute('aria-disabled', String(content.busy));
      }
    });
  }
}
