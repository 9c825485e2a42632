import type { FoldedNets } from '../read/fold/folded-nets.js';
import { labelsOf } from '../read/fold/folded-nets.js';
import { netPattern } from '../view/net-pattern.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { Store } from './store.js';
import type { Workshop } from './workshop.js';

/**
 * Shows a file that came with its nets as it is: the model, which folds, its nets beside it, and what one can do with
 * it. Pieces are chosen in both.
 */
export class ExhibitPanel extends Panel {
  private readonly card = this.find('#exhibit', HTMLElement);
  private readonly room = this.find('#workshop', HTMLElement);
  private readonly title = this.find('#exhibit-title', HTMLElement);
  private readonly words = this.find('#exhibit-words', HTMLElement);
  private readonly figure = this.find('#exhibit-figure', HTMLElement);
  private readonly nets = this.find('#exhibit-nets', HTMLElement);
  private readonly chosen = this.find('#exhibit-chosen', HTMLElement);
  private readonly back = this.find('#exhibit-back', HTMLButtonElement);
  /** Per face of the model: its part. */
  private labels = new Int32Array();
  private shown: FoldedNets | null = null;

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly workshop: Workshop,
  ) {
    super(place);
    this.back.addEventListener('click', () => store.leaveExhibit());
    store.on('scene', () => this.follow());
    store.on('selection', () => this.mark());
  }

  /** Chooses the piece of a face of the model; none for what is beside it. */
  press(face: number): void {
    this.choose(this.labels[face] ?? -1);
  }

  private follow(): void {
    const { scene, choice, run } = this.store;
    const exhibit = scene === 'exhibit' ? (choice.model?.exhibit ?? null) : null;
    this.card.hidden = this.figure.hidden = exhibit === null;
    this.room.toggleAttribute('data-exhibit', exhibit !== null);
    this.back.hidden = run === null;
    if (exhibit === this.shown) return;
    this.shown = exhibit;
    this.nets.replaceChildren();
    if (exhibit) this.show(exhibit, choice.model!.name);
  }

  private show(exhibit: FoldedNets, name: string): void {
    const { pieces } = exhibit;
    this.labels = Int32Array.from(labelsOf(exhibit));
    this.title.textContent = name;
    this.words.textContent = this.told.exhibit.lead(pieces.length);
    this.workshop.exhibit(name, exhibit);
    const pattern = netPattern(pieces, this.told.exhibit.nets(name, pieces.length));
    // An image would hide from screen readers that there is something to press.
    pattern.setAttribute('role', 'group');
    for (const area of pattern.querySelectorAll('[data-area]')) this.makeButton(area);
    this.nets.append(pattern);
    this.mark();
  }

  private makeButton(area: Element): void {
    const name = area.getAttribute('data-area') ?? '';
    const piece = this.shown?.pieces.find((each) => each.name === name);
    area.setAttribute('role', 'button');
    area.setAttribute('tabindex', '0');
    area.setAttribute('aria-label', this.told.exhibit.piece(name));
    const press = (): void => this.choose(piece?.part ?? -1);
    area.addEventListener('click', press);
    area.addEventListener('keydown', (event) => {
      if (!(event instanceof KeyboardEvent) || !['Enter', ' '].includes(event.key)) return;
      event.preventDefault();
      press();
    });
  }

  /** Chooses a part, or none any more if it is chosen already. */
  private choose(part: number): void {
    const isOff = part < 0 || this.store.selection.includes(part);
    this.store.select(isOff ? [] : [part]);
  }

  private mark(): void {
    if (!this.shown) return;
    const { selection } = this.store;
    const chosen = this.shown.pieces.filter(({ part }) => selection.includes(part));
    const names = chosen.map(({ name }) => name);
    for (const area of this.nets.querySelectorAll('[data-area]')) {
      const isChosen = names.includes(area.getAttribute('data-area') ?? '');
      area.setAttribute('aria-pressed', String(isChosen));
    }
    this.nets.toggleAttribute('data-chosen', names.length > 0);
    this.chosen.textContent = names.length > 0 ? this.told.exhibit.chosen(names) : '';
  }
}
