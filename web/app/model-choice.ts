import type { Choice } from './choice.js';
import type { OptionsForm } from './options-form.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { SampleGallery } from './sample-gallery.js';

/** Names the model that is chosen, and lets the button be pressed for it. */
export class ModelChoice extends Panel {
  private readonly words = this.find('#chosen', HTMLElement);
  /** Shown while nothing is chosen. */
  private readonly formats = this.words.textContent ?? '';

  constructor(
    place: StudioPlace,
    private readonly form: OptionsForm,
    private readonly gallery: SampleGallery,
  ) {
    super(place);
  }

  show({ model, opening }: Choice): void {
    const { choice } = this.told;
    const words = opening ? choice.opening : choice.chosen;
    const names = model ? [model.name, ...(model.added ?? [])] : [];
    this.words.textContent = model ? words(names) : this.formats;
    this.gallery.mark(model?.name ?? null);
    this.form.ready = model !== null;
  }
}
