import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Pixels to be left between the card and what was clicked. */
const air = 16;

/** The card of what is chosen on the sheets: it lies over them, so that nothing moves when it comes or goes. */
export class SheetCard extends Panel {
  protected readonly card: HTMLElement;

  /** @param selector of the card */
  constructor(place: StudioPlace, selector: string) {
    super(place);
    this.card = this.find(selector, HTMLElement);
  }

  /** Whether the keyboard is in the card. */
  get hasFocus(): boolean {
    return this.card.matches(':focus-within');
  }

  /** Lays the card at the lower end of what is seen of the sheets, or at the upper one if it would lie over a place there. */
  keepOff(below: number): void {
    this.card.dataset['end'] = 'bottom';
    const { top, bottom } = this.card.getBoundingClientRect();
    if (below > top - air && below < bottom + air) this.card.dataset['end'] = 'top';
  }

  /** Changes what the card shows; the keyboard stays in it, though the button that was pressed may go. */
  protected change(show: () => void): void {
    const { hasFocus } = this;
    show();
    if (hasFocus && !this.hasFocus) this.card.focus({ preventScroll: true });
  }
}
