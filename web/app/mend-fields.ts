import type { Settings } from '../model/options.js';
import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What is mended of a model only if a person wants it. */
export type Mending = Pick<Settings, 'fill-holes' | 'inside'>;

/** Leaves a model as it is. */
export const noMending: Mending = { 'fill-holes': 'off', inside: 'keep' };

/** Marks a choice that belongs to the model that is chosen, and not to a person's habits. */
const mark = 'data-proposed';

/**
 * The fields for holes and for bodies inside others. What is set for a model is marked, and leaves with it; what a
 * person chooses here stays.
 */
export class MendFields extends Panel {
  private readonly holes = this.find('#fill-holes', HTMLSelectElement);
  private readonly inside = this.find('#inside', HTMLSelectElement);

  constructor(place: StudioPlace) {
    super(place);
    for (const list of [this.holes, this.inside]) {
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
    };
  }

  /** Writes what the chosen model is to have, and marks it. */
  set({ 'fill-holes': holes, inside }: Partial<Mending>): void {
    if (typeof holes === 'number') this.list(holes);
    if (holes !== undefined) this.write(this.holes, String(holes));
    if (inside !== undefined) this.write(this.inside, inside);
  }

  /** Takes out what was set for another model. */
  forget(): void {
    if (this.holes.hasAttribute(mark)) this.set({ 'fill-holes': noMending['fill-holes'] });
    if (this.inside.hasAttribute(mark)) this.set({ inside: noMending.inside });
    for (const list of [this.holes, this.inside]) list.removeAttribute(mark);
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
