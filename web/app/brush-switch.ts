import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** The switch that makes a brush of the hand on the model, while that has pieces. */
export class BrushSwitch extends Panel {
  private readonly box = this.find('#brush', HTMLInputElement);
  private readonly label = this.find('#brush-switch', HTMLElement);
  private readonly hint = this.find('#brush-hint', HTMLElement);
  private readonly picture = this.find('#model-picture', HTMLElement);

  /** @param onSwitch hears whether hands paint, whenever that may have changed */
  constructor(
    place: StudioPlace,
    private readonly onSwitch: (isOn: boolean) => void,
  ) {
    super(place);
    this.box.addEventListener('change', () => this.show());
  }

  /** Whether hands paint. */
  get isOn(): boolean {
    return this.box.checked && !this.label.hidden;
  }

  /** Offers to paint, or takes that back. */
  set offered(offered: boolean) {
    this.label.hidden = !offered;
    if (!offered) this.box.checked = false;
    this.show();
  }

  private show(): void {
    this.hint.hidden = !this.isOn;
    this.picture.toggleAttribute('data-painting', this.isOn);
    this.onSwitch(this.isOn);
  }
}
