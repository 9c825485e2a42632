import type { ModelFile } from './model-file.js';
import type { OptionsForm } from './options-form.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { SampleGallery } from './sample-gallery.js';

/** The model that the button unfolds. A file is chosen once the engine could read it, and not before. */
export class ModelChoice extends Panel {
  private readonly words = this.find('#chosen', HTMLElement);
  /** Shown while nothing is chosen. */
  private readonly formats = this.words.textContent ?? '';
  private readable: ModelFile | null = null;
  /** Not read yet. */
  private candidate: ModelFile | null = null;
  private opening = false;

  constructor(
    place: StudioPlace,
    private readonly form: OptionsForm,
    private readonly gallery: SampleGallery,
  ) {
    super(place);
  }

  /** Null if there is none. */
  get model(): ModelFile | null {
    return this.candidate ?? this.readable;
  }

  /** Takes a file that may be one. */
  take(model: ModelFile): void {
    this.candidate = model;
    this.show();
  }

  /** The file is being read. */
  open(): void {
    this.opening = this.candidate !== null;
    this.show();
  }

  /** It is a model. */
  accept(): void {
    this.readable = this.model;
    this.drop();
  }

  /** It is none, and is dropped: the one before is chosen again, if there is one. */
  drop(): void {
    this.candidate = null;
    this.leave();
  }

  /** Nobody knows, as it was not read to its end. */
  leave(): void {
    this.opening = false;
    this.show();
  }

  private show(): void {
    const { model, opening } = this;
    const verb = opening ? 'Opening' : 'Chosen';
    this.words.textContent = model ? `${verb}: ${model.name}` : this.formats;
    this.gallery.mark(model?.name ?? null);
    this.form.ready = model !== null && !opening;
  }
}
