import { flapHeights } from '../model/default-options.js';
import type { EdgeAction } from '../model/edge-edits.js';
import { heightStep } from '../model/sheet-flaps.js';
import type { StudioPlace } from './place.js';
import type { PlaceWalk } from './place-walk.js';
import { onPress } from './press.js';
import { SheetCard } from './sheet-card.js';
import { WrittenField } from './written-field.js';

/** What the card says and offers. */
export interface EdgeCardContent {
  words: string;
  /** What can be done. */
  actions: readonly EdgeAction[];
  /** Of the flap, in mm; null without one. */
  height: number | null;
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
  /** The flap shall be so high, mm. */
  setHeight(height: number): void;
  /** Goes to the next place of a walk, or with -1 to the one before. */
  step(by: 1 | -1): void;
  close(): void;
}

/** The card of the edge that is chosen. */
export class EdgeCard extends SheetCard {
  private readonly words = this.find('#edge-words', HTMLElement);
  private readonly outcome = this.find('#edge-outcome', HTMLElement);
  private readonly gift = this.find('#edge-gift', HTMLButtonElement);
  private readonly heightField = this.find('#edge-height', HTMLInputElement);
  private readonly height = new WrittenField(this.heightField, (text) => this.applyHeight(text));
  private readonly heightLabel = this.find('#edge-height-label', HTMLElement);
  private readonly walk = this.find('#edge-walk', HTMLElement);
  private readonly walkWords = this.find('#edge-walk-words', HTMLElement);
  private readonly walkButtons = [...this.walk.querySelectorAll<HTMLButtonElement>('[data-walk]')];
  private readonly buttons: readonly HTMLButtonElement[];

  constructor(
    place: StudioPlace,
    private readonly listener: EdgeCardListener,
  ) {
    super(place, '#edge-card');
    this.heightField.min = String(flapHeights.least);
    this.heightField.max = String(flapHeights.most);
    this.heightField.step = String(heightStep);
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
    if (!content) return this.height.forget();
    this.change(() => {
      this.words.textContent = content.words;
      this.outcome.textContent = content.outcome;
      this.gift.textContent = content.gift;
      this.heightLabel.hidden = content.height === null;
      this.heightField.readOnly = content.busy;
      this.showHeight(content.height);
      this.walk.hidden = content.walk === null;
      this.walkWords.textContent = content.walk?.wordsIn(this.told) ?? '';
      for (const button of this.walkButtons) button.hidden = content.walk?.isLong !== true;
      for (const button of this.buttons) {
        button.hidden = !content.actions.includes(button.dataset['action'] as EdgeAction);
        button.setAttribute('aria-disabled', String(content.busy));
      }
    });
  }

  /** Shows how high the flap is, or would be, in mm. */
  showHeight(height: number | null): void {
    this.height.show(height === null ? '' : String(Number(height.toFixed(1))));
  }

  private applyHeight(text: string): void {
    // A step from where a narrow place has left a flap is no whole one, which is no fault.
    const asked = Number(text);
    const isUsable = asked >= flapHeights.least && asked <= flapHeights.most;
    if (isUsable && !this.heightField.readOnly) this.listener.setHeight(asked);
    else this.height.forget();
  }
}
