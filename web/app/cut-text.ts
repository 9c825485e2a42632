import type { StudioPlace } from './place.js';

/**
 * Words in a place of fixed size. What does not fit there is cut, and a button, which is there only then, shows all of
 * it over what is below, and cuts it again.
 */
export class CutText {
  /**
   * @param box gets the attribute `data-open` while all is shown
   * @param words cut by their style unless that is there
   * @param button has what it says in `data-more` and `data-less`
   */
  constructor(
    { life }: Pick<StudioPlace, 'life'>,
    private readonly box: HTMLElement,
    private readonly words: HTMLElement,
    private readonly button: HTMLButtonElement,
  ) {
    button.addEventListener('click', () => this.open(!this.isOpen));
    const observer = new ResizeObserver(() => this.look());
    observer.observe(words);
    life.addEventListener('abort', () => observer.disconnect());
    this.reset();
  }

  /** Other words are there. */
  reset(): void {
    this.open(false);
  }

  private get isOpen(): boolean {
    return this.box.hasAttribute('data-open');
  }

  private open(isOpen: boolean): void {
    this.box.toggleAttribute('data-open', isOpen);
    this.button.setAttribute('aria-expanded', String(isOpen));
    const { more = '', less = '' } = this.button.dataset;
    this.button.textContent = isOpen ? less : more;
    this.look();
  }

  /** A pixel is what rounding makes. */
  private look(): void {
    const { scrollHeight, clientHeight } = this.words;
    this.button.hidden = !this.isOpen && scrollHeight <= clientHeight + 1;
  }
}
