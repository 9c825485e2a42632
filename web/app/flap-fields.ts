import { defaultOptions } from '../model/default-options.js';
import type { FlapSide, JobOptions } from '../model/job.js';
import { find } from './dom.js';

const sides: readonly FlapSide[] = ['one', 'alternate', 'both', 'none'];

/** The fields for flaps; their height is asked for only where there are any. */
export class FlapFields {
  private readonly side = find('#flap-side', HTMLSelectElement);
  private readonly height = find('#flap-height', HTMLInputElement);

  constructor() {
    this.height.placeholder = String(defaultOptions.flapHeight);
    this.side.addEventListener('change', () => {
      this.height.disabled = this.side.value === 'none';
    });
  }

  /** What the fields say now; they must be valid. */
  read(): Pick<JobOptions, 'flapSide' | 'flapHeight'> {
    const { value, valueAsNumber } = this.height;
    return {
      flapSide: sides.find((side) => side === this.side.value) ?? defaultOptions.flapSide,
      flapHeight: value === '' ? defaultOptions.flapHeight : valueAsNumber,
    };
  }
}
