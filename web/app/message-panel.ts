import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** The place where failures are told; what else is on the page stays as it is. */
export class MessagePanel extends Panel {
  private readonly panel = this.find('#message', HTMLElement);
  private readonly words = this.find('#message-words', HTMLElement);

  constructor(place: StudioPlace) {
    super(place);
    this.find('#message-close', HTMLButtonElement).addEventListener('click', () => this.clear());
  }

  /** Shows a headline and sentences below it. */
  show(headline: string, ...sentences: string[]): void {
    this.words.replaceChildren(
      make('strong', { textContent: headline }),
      ...sentences.map((textContent) => make('p', { textContent })),
    );
    this.panel.hidden = false;
    this.panel.scrollIntoView({ block: 'nearest' });
  }

  clear(): void {
    this.panel.hidden = true;
    this.words.replaceChildren();
  }
}
