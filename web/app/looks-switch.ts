import type { Looks } from '../model/looks.js';
import type { ModelFile } from '../model/model-files.js';
import type { ModelMessage } from '../view/model-message.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** The switch that shows the finished model as its files say that it looks; it stays as it is for the next one. */
export class LooksSwitch extends Panel {
  private readonly box = this.find('#looks', HTMLInputElement);
  private readonly label = this.find('#looks-switch', HTMLElement);
  private looks: Looks | null = null;
  private isHeld = false;
  /** Those that were handed over: they may be large, and are the same for all results of a model. */
  private pictures: readonly ModelFile[] | null = null;

  constructor(
    place: StudioPlace,
    private readonly post: (message: ModelMessage) => void,
  ) {
    super(place);
    this.box.addEventListener('change', () => this.show());
  }

  /** Takes the looks of the model that is shown; null for one whose files say nothing of them. */
  offer(looks: Looks | null): void {
    this.looks = looks;
    this.label.hidden = looks === null;
    if (looks) this.show();
  }

  /** Shows the parts instead, whatever the switch says, as long as this is set. */
  set held(isHeld: boolean) {
    if (this.isHeld === isHeld) return;
    this.isHeld = isHeld;
    if (this.looks) this.show();
  }

  private show(): void {
    const looks = this.box.checked && !this.isHeld ? this.looks : null;
    if (looks && looks.pictures !== this.pictures) {
      this.pictures = looks.pictures;
      this.post({ type: 'pictures', pictures: looks.pictures });
    }
    this.post({
      type: 'looks',
      looks: looks && { surface: looks.surface, materials: looks.materials },
    });
  }
}
