import type { Settings } from '../model/options.js';
import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What is mended of a model only if a person wants it. */
export type Mending = Pick<Settings, 'fill-holes' | 'inside' | 'crossing'>;

/** Leaves a model as it is. */
export const noMending: Mending = { 'fill-holes': 'off', inside: 'keep', crossing: 'keep' };

/** Marks a choice that belongs to the model that is chosen, and not to a person's habits. */
const mark = 'data-proposed';

/**
 * The fields for holes and for bodies inside others or through each other. What is set for a model is marked, and leaves with it; what a
 * person chooses here stays.
 */
export class MendFields extends Panel {
  private readonly holes = this.find('#fill-holes', HTMLSelectElement);
  private readonly inside = this.find('#inside', HTMLSelectElement);
  private readonly crossing = this.find('#crossing', HTMLSelectElement);
  private readonly lists = [this.holes, this.inside, this.crossing];

  constructor(place: StudioPlace) {
    super(place);
    for (const list of this.lists) {
      list.addEventListener('change', ({ isTrusted }) => {
        if (isTrusted) list.removeAttribute(mark);
      });
    }
  }

  /** What the fields say now. */
  get value(): Mending {
    const { value } = this.holes;
    return {
      'fill-holes': value === 'off' || value === 'all' ? value : Number(value),
      inside: this.inside.value === 'drop' ? 'drop' : 'keep',
      crossing: this.crossing.value === 'unite' ? 'unite' : 'keep',
    };
  }

  /** Writes what the chosen model is to have, and marks it. */
  set({ 'fill-holes': holes, inside, crossing }: Partial<Mending>): void {
    if (typeof holes === 'number') this.list(holes);
    if (holes !== undefined) this.write(this.holes, String(holes));
    if (inside !== undefined) this.write(this.inside, inside);
    if (crossing !== undefined) this.write(this.crossing, crossing);
  }

  /** Takes out what was set for another model. */
  forget(): void {
    if (this.holes.hasAttribute(mark)) this.set({ 'fill-holes': noMending['fill-holes'] });
    if (this.inside.hasAttribute(mark)) this.set({ inside: noMending.inside });
    if (this.crossing.hasAttribute(mark)) this.set({ crossing: noMending.crossing });
    for (const list of this.lists) list.removeAttribute(mark);
  }

  private write(list: HTMLSelectElement, value: string): void {
    list.setAttribute(mark, '');
    if (list.value === value) return;
    list.value = value;
    list.dispatchEvent(new Event('change', { bubbles: true }));
  }

  /** Offers a width that is no common one. */
  private list(percent: number): void {
    const value = String(percent);
    if ([...this.holes.options].some((option) => option.value === value)) return;
    const textContent = this.told.form.holesUpTo(percent);
    this.holes.options[0]?.after(make('option', { value, textContent }));
  }
}
