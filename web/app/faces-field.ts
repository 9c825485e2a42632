import type { Settings } from '../model/options.js';
import { fill } from './fill.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Marks a number that belongs to the model that is chosen, and not to a person's habits. */
const mark = 'data-proposed';

/**
 * The field that says to how many triangles the model is simplified. What is set for a model is marked, and leaves
 * with it; what a person writes stays.
 */
export class FacesField extends Panel {
  private readonly field = this.find('#faces', HTMLInputElement);
  private readonly hint = this.find('#faces-hint', HTMLElement);

  constructor(place: StudioPlace) {
    super(place);
    this.field.addEventListener('input', (event) => {
      if (event.isTrusted) this.label(false);
    });
  }

  /** What the field says; `off` while it makes no sense. */
  get value(): Settings['faces'] {
    const { value, validity, valueAsNumber } = this.field;
    return value === '' || !validity.valid ? 'off' : valueAsNumber;
  }

  /** What a person has asked for: `off` where the number was set for a model. */
  get own(): Settings['faces'] {
    return this.field.hasAttribute(mark) ? 'off' : this.value;
  }

  /** Writes what the chosen model is to have, and marks it. */
  set(faces: Settings['faces']): void {
    this.label(true);
    this.write(faces);
  }

  /** Writes a number that is to stay for all models, if the field takes it. */
  fill(value: string): void {
    this.label(false);
    fill(this.field, value);
  }

  /** Takes out what was set for another model. */
  forget(): void {
    if (!this.field.hasAttribute(mark)) return;
    this.label(false);
    this.write('off');
  }

  /** Calls `listener` whenever the number changes. */
  onChange(listener: () => void): void {
    this.field.addEventListener('input', listener);
  }

  private write(faces: Settings['faces']): void {
    this.field.value = faces === 'off' ? '' : String(faces);
    this.field.dispatchEvent(new Event('input', { bubbles: true }));
  }

  private label(isSet: boolean): void {
    this.field.toggleAttribute(mark, isSet);
    this.hint.hidden = !isSet;
  }
}
