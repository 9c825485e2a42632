import type { PickedFile } from './model-file.js';
import { Panel } from './panel.js';
import { pickedFiles } from './file-picker.js';
import type { StudioPlace } from './place.js';
import type { Store } from './store.js';

/** Takes a corrected file of the model on the page. */
export class ReplaceButton extends Panel {
  private readonly input = this.find('#replace-file', HTMLInputElement);
  private readonly button = this.find('#replace', HTMLButtonElement);

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    onFiles: (files: readonly PickedFile[]) => void,
  ) {
    super(place);
    this.button.addEventListener('click', () => {
      if (this.button.getAttribute('aria-disabled') !== 'true') this.input.click();
    });
    this.input.addEventListener('change', () => {
      const files = pickedFiles(this.input);
      if (files.length > 0) onFiles(files);
    });
    for (const topic of ['work', 'scene'] as const) store.on(topic, () => this.follow());
  }

  private follow(): void {
    const { scene, work } = this.store;
    this.button.hidden = scene !== 'result';
    this.button.setAttribute('aria-disabled', String(work !== 'idle'));
  }
}
