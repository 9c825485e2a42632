import { find, make } from './dom.js';

/** The place where failures are told; what else is on the page stays as it is. */
export class MessagePanel {
  private readonly panel = find('#message', HTMLElement);
  private readonly words = find('#message-words', HTMLElement);

  constructor() {
    find('#message-close', HTMLButtonElement).addEventListener('click', () => this.clear());
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
