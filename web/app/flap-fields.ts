import { defaultOptions } from '../model/default-options.js';
import type { FlapSide, FlapStyle, IdPlace } from '../model/job-options.js';
import type { Settings } from '../model/options.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

const idPlaces: readonly IdPlace[] = ['flap', 'both', 'inside', 'outside', 'none'];
const sides = ['one', 'alternate', 'both'] as const satisfies readonly FlapSide[];
const styles: readonly FlapStyle[] = ['run', 'zigzag', 'edge'];

/** The fields for flaps and edge ids; how flaps look is asked only where there are some. */
export class FlapFields extends Panel {
  private readonly side = this.find('#flap-side', HTMLSelectElement);
  private readonly height = this.find('#flap-height', HTMLInputElement);
  private readonly style = this.find('#flap-style', HTMLSelectElement);
  private readonly strips = this.find('#strips', HTMLInputElement);
  private readonly ids = this.find('#ids', HTMLSelectElement);

  constructor(place: StudioPlace) {
    super(place);
    this.height.placeholder = String(defaultOptions.flapHeight);
    this.side.addEventListener('change', () => {
      this.height.disabled = this.side.value === 'none';
      this.style.disabled = this.height.disabled;
    });
  }

  /** What the fields say now; they must be valid. */
  read(): Pick<Settings, 'flap-side' | 'flap-style' | 'flaps' | 'glue-strips' | 'ids'> {
    return {
      'flap-side': sides.find((side) => side === this.side.value) ?? 'one',
      'flap-style': styles.find((style) => style === this.style.value) ?? defaultOptions.flapStyle,
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
