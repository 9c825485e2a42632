import { CutText } from './cut-text.js';
import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What a message offers to do about what it tells. */
export interface Offer {
  words: string;
  act(): void;
}

/** The place where failures are told; what else is on the page stays as it is. */
export class MessagePanel extends Panel {
  private readonly panel = this.find('#message', HTMLElement);
  private readonly words = this.find('#message-words', HTMLElement);
  private readonly offer = this.find('#message-offer', HTMLButtonElement);
  private readonly cut: CutText;
  private act: Offer['act'] = () => undefined;

  constructor(place: StudioPlace) {
    super(place);
    const more = this.find('#message-more', HTMLButtonElement);
    this.cut = new CutText(place, this.panel, this.words, more);
    this.find('#message-close', HTMLButtonElement).addEventListener('click', () => this.clear());
    this.offer.addEventListener('click', () => {
      const { act } = this;
      this.clear();
      act();
    });
  }

  /** Shows a headline and sentences below it. */
  show(headline: string, ...sentences: string[]): void {
    this.tell(headline, sentences, null);
  }

  /** Shows them with a button for what can be done about it. */
  ask(offer: Offer, headline: string, ...sentences: string[]): void {
    this.tell(headline, sentences, offer);
  }

  clear(): void {
    this.panel.hidden = true;
    this.words.replaceChildren();
  }

  private tell(headline: string, sentences: readonly string[], offer: Offer | null): void {
    this.words.replaceChildren(
      make('strong', { textContent: headline }),
      ...sentences.flatMap((textContent) => [make('p', { textContent }), ' ']),
    );
    this.offer.hidden = offer === null;
    this.offer.textContent = offer?.words ?? '';
    this.act = () => offer?.act();
    this.panel.hidden = false;
    this.cut.reset();
    this.panel.scrollIntoView({ block: 'nearest' });
  }
}
