import type { JobResult } from '../model/job.js';
import { comparedFacts, type ComparedFact } from './comparison-words.js';
import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { onPress } from './press.js';
import type { Store } from './store.js';

export interface ComparisonListener {
  /** Draws the sheets of a result as those on the page are drawn. */
  draw(result: JobResult): Promise<HTMLLIElement[]>;
  /** Takes the last change back. */
  undo(): void;
}

function rowOf({ label, before, now }: ComparedFact): HTMLTableRowElement {
  const row = make(
    'tr',
    {},
    make('th', { scope: 'row', textContent: label }),
    make('td', { textContent: before }),
    make('td', { textContent: now }),
  );
  row.toggleAttribute('data-differs', before !== now);
  return row;
}

/** The result before the last change beside the one on the page: figures, sheets, and the choice between them. */
export class ComparisonPanel extends Panel {
  private readonly button = this.find('#compare', HTMLButtonElement);
  private readonly dialog = this.find('#comparison', HTMLDialogElement);
  private readonly facts = this.find('#comparison-facts', HTMLTableSectionElement);
  private readonly sides = {
    before: this.find('#sheets-before', HTMLOListElement),
    now: this.find('#sheets-now', HTMLOListElement),
  };

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly listener: ComparisonListener,
  ) {
    super(place);
    onPress(this.button, () => void this.open());
    this.find('#comparison-keep', HTMLButtonElement).addEventListener('click', () => this.close());
    this.find('#comparison-back', HTMLButtonElement).addEventListener('click', () => {
      this.close();
      listener.undo();
    });
    // Pictures of sheets are large.
    this.dialog.addEventListener('close', () => this.clear());
    store.on('work', () => this.offer());
    store.on('scene', () => this.offer());
  }

  /** The result that the one on the page can be compared with; null if there is none, or if only lines look otherwise. */
  private get before(): JobResult | null {
    const { before, canMove, run } = this.store;
    return before && canMove && run && before.hash !== run.result.hash ? before : null;
  }

  private offer(): void {
    this.button.setAttribute('aria-disabled', String(this.before === null));
    // What is on the page is about to be another one.
    if (this.store.work !== 'idle') this.close();
  }

  private async open(): Promise<void> {
    const { before } = this;
    const { run } = this.store;
    if (!before || !run) return;
    const facts = comparedFacts(this.told, before, run.result, run.settings.margin);
    this.facts.replaceChildren(...facts.map(rowOf));
    this.dialog.showModal();
    const [old, present] = [await this.listener.draw(before), await this.listener.draw(run.result)];
    if (!this.dialog.open || this.store.run !== run) return;
    this.sides.before.replaceChildren(...old);
    this.sides.now.replaceChildren(...present);
  }

  private close(): void {
    if (this.dialog.open) this.dialog.close();
  }

  private clear(): void {
    for (const list of Object.values(this.sides)) list.replaceChildren();
  }
}
