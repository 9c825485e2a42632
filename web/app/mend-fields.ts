import type { Settings } from '../model/options.js';
import { switchableSteps, type RepairStep } from '../model/repair-steps.js';
import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What is mended of a model, where a person decides. */
export type Mending = Pick<Settings, 'repair' | 'fill-holes' | 'inside' | 'crossing'>;

/** Does all that is done unless someone switches it off, and nothing that is done on request. */
export const usualMending: Mending = {
  repair: [],
  'fill-holes': 'off',
  inside: 'keep',
  crossing: 'keep',
};

/** Marks a choice that belongs to the model that is chosen, and not to a person's habits. */
const mark = 'data-proposed';

/**
 * The fields for steps of the repair, for holes and for bodies inside others or through each other. What is set for a
 * model is marked, and leaves with it; what a person chooses here stays.
 */
export class MendFields extends Panel {
  private readonly holes = this.find('#fill-holes', HTMLSelectElement);
  private readonly inside = this.find('#inside', HTMLSelectElement);
  private readonly crossing = this.find('#crossing', HTMLSelectElement);
  private readonly steps = new Map<RepairStep, HTMLInputElement>();

  constructor(place: StudioPlace) {
    super(place);
    const box = this.find('#repair-steps', HTMLElement);
    for (const step of switchableSteps) {
      const field = make('input', { type: 'checkbox', id: `repair-${step}`, checked: true });
      this.steps.set(step, field);
      box.append(make('label', { className: 'tick' }, field, this.told.repairSteps[step]));
    }
    for (const field of this.fields) {
      field.addEventListener('change', ({ isTrusted }) => {
        if (isTrusted) field.removeAttribute(mark);
      });
    }
  }

  /** What the fields say now. */
  get value(): Mending {
    const { value } = this.holes;
    return {
      repair: switchableSteps.filter((step) => this.steps.get(step)?.checked === false),
      'fill-holes': value === 'off' || value === 'all' ? value : Number(value),
      inside: this.inside.value === 'drop' ? 'drop' : 'keep',
      crossing: this.crossing.value === 'unite' ? 'unite' : 'keep',
    };
  }

  /** Writes what the chosen model is to have, and marks it. */
  set({ repair, 'fill-holes': holes, inside, crossing }: Partial<Mending>): void {
    for (const [step, field] of repair ? this.steps : []) this.tick(field, !repair?.includes(step));
    if (typeof holes === 'number') this.list(holes);
    if (holes !== undefined) this.write(this.holes, String(holes));
    if (inside !== undefined) this.write(this.inside, inside);
    if (crossing !== undefined) this.write(this.crossing, crossing);
  }

  /** Takes out what was set for another model. */
  forget(): void {
    for (const field of this.steps.values()) if (field.hasAttribute(mark)) this.tick(field, true);
    if (this.holes.hasAttribute(mark)) this.set({ 'fill-holes': usualMending['fill-holes'] });
    if (this.inside.hasAttribute(mark)) this.set({ inside: usualMending.inside });
    if (this.crossing.hasAttribute(mark)) this.set({ crossing: usualMending.crossing });
    for (const field of this.fields) field.removeAttribute(mark);
  }

  private get fields(): (HTMLInputElement | HTMLSelectElement)[] {
    return [...this.steps.values(), this.holes, this.inside, this.crossing];
  }

  /** A step that is not chosen otherwise stays as a person has it. */
  private tick(field: HTMLInputElement, isOn: boolean): void {
    if (field.checked === isOn) return;
    field.setAttribute(mark, '');
    field.checked = isOn;
    field.dispatchEvent(new Event('change', { bubbles: true }));
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
