import { switchableSteps, type RepairStep } from '../model/repair-steps.js';
import type { RepairRow } from './check-words.js';
import { make } from './dom.js';
import type { MendFields } from './mend-fields.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Lists what was done to a model, each step that can be switched off with its switch. */
export class RepairList extends Panel {
  private readonly box = this.find('#check-repaired', HTMLElement);
  private readonly list = this.find('#check-repaired ul', HTMLElement);
  private readonly switches = new Map<RepairStep, HTMLInputElement>();

  constructor(
    place: StudioPlace,
    private readonly fields: MendFields,
  ) {
    super(place);
    for (const step of switchableSteps)
      this.switches.set(step, make('input', { type: 'checkbox' }));
    this.list.addEventListener('change', () => this.fields.set({ repair: this.off }));
  }

  /** Shows what was done, and what the fields say about it. */
  update(rows: readonly RepairRow[]): void {
    const off = this.fields.value.repair;
    for (const [step, input] of this.switches) input.checked = !off.includes(step);
    // Whoever has used a switch stays at it.
    const used = [...this.switches.values()].find((input) => input.matches(':focus'));
    this.list.replaceChildren(...rows.map((row) => this.item(row)));
    this.box.hidden = rows.length === 0;
    used?.focus({ preventScroll: true });
  }

  private get off(): RepairStep[] {
    return switchableSteps.filter((step) => this.switches.get(step)?.checked === false);
  }

  private item({ step, words }: RepairRow): HTMLElement {
    const input = step && this.switches.get(step);
    if (!input) return make('li', { textContent: words });
    const label = make('label', { className: 'tick' }, input, this.told.repairSteps[step]);
    return make('li', { className: 'check__step' }, label, make('p', { textContent: words }));
  }
}
