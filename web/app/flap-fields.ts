import { defaultOptions } from '../model/default-options.js';
import type { FlapSide, IdPlace, JobOptions } from '../model/job.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

const idPlaces: readonly IdPlace[] = ['both', 'inside', 'flap', 'none'];
const sides: readonly FlapSide[] = ['one', 'alternate', 'both', 'none'];

/** The fields for flaps and edge ids; a height is asked for only where there are flaps. */
export class FlapFields extends Panel {
  private readonly side = this.find('#flap-side', HTMLSelectElement);
  private readonly height = this.find('#flap-height', HTMLInputElement);

  private readonly ids = this.find('#ids', HTMLSelectElement);

  constructor(place: StudioPlace) {
    super(place);
    this.height.placeholder = String(defaultOptions.flapHeight);
    this.side.addEventListener('change', () => {
      this.height.disabled = this.side.value === 'none';
    });
  }

  /** What the fields say now; they must be valid. */
  read(): Pick<JobOptions, 'flapSide' | 'flapHeight' | 'ids'> {
    const { value, valueAsNumber } = this.height;
    return {
      flapSide: sides.find((side) => side === this.side.value) ?? defaultOptions.flapSide,
      ids: idPlaces.find((place) => place === this.ids.value) ?? defaultOptions.ids,
      flapHeight: value === '' ? defaultOptions.flapHeight : valueAsNumber,
    };
  }
}
