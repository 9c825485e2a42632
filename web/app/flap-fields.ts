import { defaultOptions } from '../model/default-options.js';
import type { FlapSide, IdPlace } from '../model/job-options.js';
import type { Settings } from '../model/options.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

const idPlaces: readonly IdPlace[] = ['flap', 'both', 'inside', 'outside', 'none'];
const sides = ['one', 'alternate', 'both'] as const satisfies readonly FlapSide[];

/** The fields for flaps and edge ids; a height is asked for only where there are flaps. */
export class FlapFields extends Panel {
  private readonly side = this.find('#flap-side', HTMLSelectElement);
  private readonly height = this.find('#flap-height', HTMLInputElement);

  private readonly strips = this.find('#strips', HTMLInputElement);
  private readonly ids = this.find('#ids', HTMLSelectElement);

  constructor(place: StudioPlace) {
    super(place);
    this.height.placeholder = String(defaultOptions.flapHeight);
    this.side.addEventListener('change', () => {
      this.height.disabled = this.side.value === 'none';
    });
  }

  /** What the fields say now; they must be valid. */
  read(): Pick<Settings, 'flap-side' | 'flaps' | 'glue-strips' | 'ids'> {
    return {
      'flap-side': sides.find((side) => side === this.side.value) ?? 'one',
      flaps: this.side.value === 'none' ? 'none' : this.flapHeight(),
      'glue-strips': this.strips.checked ? 'all' : 'none',
      ids: idPlaces.find((place) => place === this.ids.value) ?? defaultOptions.ids,
    };
  }

  private flapHeight(): number {
    const { value, valueAsNumber } = this.height;
    return value === '' ? defaultOptions.flapHeight : valueAsNumber;
  }
}
