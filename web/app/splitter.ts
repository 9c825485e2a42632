import { clampedSplit, splitAfterKey, splitAt, splitRange } from '../view/split-share.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Where the share is kept from one visit to the next. */
const memory = 'foldwright.split';

function recalled(): number {
  try {
    return clampedSplit(Number(localStorage.getItem(memory) ?? splitRange.usual));
  } catch {
    // A browser that keeps nothing is no reason to fail.
    return splitRange.usual;
  }
}

/** The border between the model and the sheets, which mouse, finger and keyboard move. */
export class Splitter extends Panel {
  private readonly bar = this.find('#splitter', HTMLElement);
  private readonly room = this.find('#result', HTMLElement);
  private share = recalled();

  constructor(place: StudioPlace) {
    super(place);
    const { bar } = this;
    bar.setAttribute('aria-valuemin', String(splitRange.least));
    bar.setAttribute('aria-valuemax', String(splitRange.most));
    bar.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      bar.setPointerCapture(event.pointerId);
      event.preventDefault();
      bar.focus({ preventScroll: true });
    });
    bar.addEventListener('pointermove', (event) => {
      if (!bar.hasPointerCapture(event.pointerId)) return;
      this.set(splitAt(event.clientX, this.room.getBoundingClientRect()));
    });
    bar.addEventListener('pointerup', () => this.remember());
    bar.addEventListener('dblclick', () => this.choose(splitRange.usual));
    bar.addEventListener('keydown', (event) => {
      const share = splitAfterKey(this.share, event.key, event.shiftKey);
      if (share === null) return;
      event.preventDefault();
      this.choose(share);
    });
    this.set(this.share);
  }

  private choose(share: number): void {
    this.set(share);
    this.remember();
  }

  private set(share: number): void {
    this.share = share;
    this.room.style.setProperty('--split', `${share}%`);
    this.bar.setAttribute('aria-valuenow', String(Math.round(share)));
    this.bar.setAttribute('aria-valuetext', this.told.result.forModel(Math.round(share)));
  }

  private remember(): void {
    try {
      localStorage.setItem(memory, String(this.share));
    } catch {
      // It is as wide as usual the next time.
    }
  }
}
