import { agoWords } from '../words/ago.js';
import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { Card } from './shelf.js';

/** What a person does with the work that is kept. */
export interface RecentListener {
  open(card: Card): void;
  rename(card: Card, name: string): void;
  copy(card: Card): void;
  remove(card: Card, isRemoved: boolean): void;
}

/** Cards that are shown at first. */
const few = 4;

/** As long as a name may be. */
const longestName = 60;

/** The work that this browser keeps, on the start screen: the last one is one press away. */
export class RecentPanel extends Panel {
  private readonly panel = this.find('#recent', HTMLElement);
  private readonly main = this.find('#recent-go-on', HTMLButtonElement);
  private readonly list = this.find('#recent-list', HTMLUListElement);
  private readonly more = this.find('#recent-more', HTMLButtonElement);
  private readonly note = this.find('#recent-note', HTMLElement);
  private readonly words = this.find('#recent-words', HTMLElement);
  private readonly undo = this.find('#recent-undo', HTMLButtonElement);
  private cards: readonly Card[] = [];
  private isWhole = false;
  private isScarce = false;
  /** Of which the name is being written. */
  private renamed: string | null = null;
  /** That was deleted last. */
  private deleted: Card | null = null;

  constructor(
    place: StudioPlace,
    private readonly listener: RecentListener,
  ) {
    super(place);
    this.main.addEventListener('click', () => {
      if (this.cards[0]) listener.open(this.cards[0]);
    });
    this.more.addEventListener('click', () => {
      this.isWhole = true;
      this.render();
      this.list.querySelectorAll<HTMLElement>('.recent__open')[few]?.focus();
    });
    this.undo.addEventListener('click', () => {
      const card = this.deleted;
      this.deleted = null;
      if (card) listener.remove(card, false);
    });
  }

  /** Shows what is kept. */
  show(cards: readonly Card[]): void {
    this.cards = cards;
    this.render();
  }

  /** Says that there is little room left. */
  warn(): void {
    this.isScarce = true;
    this.render();
  }

  /** Says that nothing can be kept here. */
  refuse(): void {
    this.panel.hidden = false;
    this.panel.dataset['state'] = 'none';
    this.words.textContent = this.told.keeping.none;
    this.note.hidden = false;
    this.undo.hidden = this.main.hidden = this.list.hidden = this.more.hidden = true;
  }

  private render(): void {
    const { cards, deleted, isWhole } = this;
    const [first] = cards;
    this.panel.hidden = !first && !deleted && !this.isScarce;
    this.main.hidden = !first;
    if (first) this.main.textContent = this.told.keeping.goOn(first.name, first.isPending);
    const shown = isWhole ? cards : cards.slice(0, few);
    this.list.replaceChildren(...shown.map((card) => this.item(card)));
    this.more.hidden = shown.length === cards.length;
    this.more.textContent = this.told.keeping.showAll(cards.length);
    const usual = this.isScarce ? this.told.keeping.scarce : this.told.keeping.kept;
    this.words.textContent = deleted ? this.told.keeping.deleted(deleted.name) : usual;
    this.undo.hidden = !deleted;
  }

  private item(card: Card): HTMLLIElement {
    const { id, name, picture } = card;
    const image = picture
      ? make('img', { src: picture, alt: '', width: 72, height: 72 })
      : make('span', { className: 'recent__blank' });
    const ago = agoWords(this.told, card.changed, Date.now());
    const when = card.isPending ? `${ago}, ${this.told.keeping.unfinished}` : ago;
    const open = make(
      'button',
      { type: 'button', className: 'recent__open', title: name },
      image,
      make('span', { className: 'recent__name', textContent: name }),
      make('small', { textContent: when }),
    );
    open.addEventListener('click', () => this.listener.open(card));
    const acts = make(
      'div',
      { className: 'recent__acts' },
      this.act(this.told.keeping.rename, name, () => this.beginRenaming(id)),
      this.act(this.told.keeping.copy, name, () => this.listener.copy(card)),
      this.act(this.told.keeping.remove, name, () => this.remove(card)),
    );
    return make('li', {}, open, id === this.renamed ? this.field(card) : acts);
  }

  private act(word: string, name: string, work: () => void): HTMLButtonElement {
    const button = make('button', { type: 'button', className: 'recent__act', textContent: word });
    button.setAttribute('aria-label', this.told.keeping.about(word, name));
    button.addEventListener('click', work);
    return button;
  }

  private remove(card: Card): void {
    this.deleted = card;
    this.listener.remove(card, true);
    // The button that was pressed goes with its card.
    this.undo.hidden = false;
    this.undo.focus({ preventScroll: true });
  }

  private beginRenaming(id: string): void {
    this.renamed = id;
    this.render();
    this.list.querySelector('input')?.select();
  }

  private field(card: Card): HTMLElement {
    const input = make('input', { type: 'text', value: card.name, maxLength: longestName });
    input.setAttribute('aria-label', this.told.keeping.newName(card.name));
    const end = (isMeant: boolean): void => {
      if (this.renamed !== card.id) return;
      this.renamed = null;
      const name = input.value.trim();
      if (isMeant && name !== '' && name !== card.name) this.listener.rename(card, name);
      this.render();
      this.list.querySelectorAll<HTMLElement>('.recent__act')[3 * this.placeOf(card)]?.focus();
    };
    input.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      end(event.key === 'Enter');
    });
    input.addEventListener('blur', () => end(true));
    return input;
  }

  private placeOf({ id }: Card): number {
    return this.cards.findIndex((card) => card.id === id);
  }
}
