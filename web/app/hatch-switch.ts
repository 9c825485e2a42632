import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** The switch for hatches, which tell parts apart where colours do not: in grey and on prints. */
export class HatchSwitch extends Panel {
  constructor(place: StudioPlace, onChange: (hatched: boolean) => void) {
    super(place);
    const box = this.find('#hatch', HTMLInputElement);
    const studio = this.find('.studio', HTMLElement);
    const report = (): void => {
      // Sheets carry both fills; which one shows is a matter of style.
      studio.toggleAttribute('data-hatched', box.checked);
      onChange(box.checked);
    };
    box.addEventListener('change', report);
    // A reloaded page may come back with the box ticked.
    report();
  }
}
