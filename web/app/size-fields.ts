import type { Sizing, Unit, Up } from '../model/job-options.js';
import type { sizings, Settings } from '../model/options.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What these fields decide. */
export type Size = Pick<Settings, (typeof sizings)[number] | 'unit' | 'up'>;

/** What numbers each kind of size takes. */
interface Amount {
  least: string;
  most: string;
  step: string;
  start: string;
}

const amounts: Readonly<Record<Exclude<Sizing, 'fit'>, Amount>> = {
  height: { least: '1', most: '100000', step: 'any', start: '150' },
  width: { least: '1', most: '100000', step: 'any', start: '150' },
  depth: { least: '1', most: '100000', step: 'any', start: '150' },
  scale: { least: '0.000001', most: '1000000', step: 'any', start: '1' },
  sheets: { least: '1', most: '1000', step: '1', start: '4' },
};

/** How large a model is wished to be: a kind of size and its number; none while the number makes no sense. */
export interface Wish {
  kind: Sizing;
  amount: number | null;
}

const units: readonly Unit[] = ['guess', 'mm', 'cm', 'm', 'in'];
const ups: readonly Up[] = ['guess', 'x', 'y', 'z'];

/** The fields for the finished size and which way is up; the number and the unit show only where they are used. */
export class SizeFields extends Panel {
  private readonly kind = this.find('#sizing', HTMLSelectElement);
  private readonly amount = this.find('#size', HTMLInputElement);
  private readonly amountField = this.find('#size-field', HTMLElement);
  private readonly amountLabel = this.find('#size-label', HTMLElement);
  private readonly unit = this.find('#unit', HTMLSelectElement);
  private readonly up = this.find('#up', HTMLSelectElement);
  private readonly unitField = this.find('#unit-field', HTMLElement);

  constructor(place: StudioPlace) {
    super(place);
    this.kind.addEventListener('change', () => this.show());
    this.show();
  }

  /** What the fields say now; they must be valid. */
  read(): Size {
    const sizing = this.sizing();
    const amount = (kind: Sizing): number | 'none' =>
      kind === sizing ? this.amount.valueAsNumber : 'none';
    return {
      height: amount('height'),
      width: amount('width'),
      depth: amount('depth'),
      scale: amount('scale'),
      sheets: amount('sheets'),
      unit: units.find((name) => name === this.unit.value) ?? 'guess',
      up: this.upwards,
    };
  }

  /** What the fields say about the size now, whether that makes sense or not. */
  get wish(): Wish {
    const { value, validity } = this.amount;
    const amount = value !== '' && validity.valid ? this.amount.valueAsNumber : null;
    return { kind: this.sizing(), amount };
  }

  /** Which way is up in the file. */
  get upwards(): Up {
    return ups.find((name) => name === this.up.value) ?? 'guess';
  }

  /** Asks for a height in mm, or for the largest that a sheet allows. */
  choose(height: number | 'fit'): void {
    this.kind.value = height === 'fit' ? 'fit' : 'height';
    this.show();
    if (height !== 'fit') this.amount.value = String(height);
    this.kind.dispatchEvent(new Event('input', { bubbles: true }));
  }

  private sizing(): Sizing {
    const { value } = this.kind;
    return Object.hasOwn(amounts, value) ? (value as keyof typeof amounts) : 'fit';
  }

  private show(): void {
    const sizing = this.sizing();
    this.unitField.hidden = sizing !== 'scale';
    this.amountField.hidden = sizing === 'fit';
    this.amount.required = sizing !== 'fit';
    if (sizing === 'fit') {
      this.amount.value = '';
      return;
    }
    const { least, most, step, start } = amounts[sizing];
    this.amountLabel.textContent = this.told.form[sizing];
    Object.assign(this.amount, { min: least, max: most, step, value: start });
  }
}
