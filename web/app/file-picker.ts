import { find } from './dom.js';

/** Offers files chosen with the picker or dropped anywhere on the page. */
export class FilePicker {
  private readonly input = find('#file', HTMLInputElement);
  private readonly veil = find('#drop-veil', HTMLElement);
  /** Entered elements minus left ones: dragging over a child leaves its parent. */
  private depth = 0;

  constructor(private readonly onFiles: (files: readonly File[]) => void) {
    this.input.addEventListener('change', () => {
      const files = [...(this.input.files ?? [])];
      // Forgotten at once, so that choosing the same file again counts as a choice.
      this.input.value = '';
      if (files.length > 0) this.onFiles(files);
    });
    window.addEventListener('dragenter', (event) => this.enter(event, 1));
    window.addEventListener('dragleave', (event) => this.enter(event, -1));
    window.addEventListener('dragover', (event) => event.preventDefault());
    window.addEventListener('drop', (event) => this.drop(event));
  }

  private enter(event: DragEvent, change: number): void {
    if (!event.dataTransfer?.types.includes('Files')) return;
    this.depth += change;
    this.veil.hidden = this.depth <= 0;
  }

  private drop(event: DragEvent): void {
    event.preventDefault();
    this.depth = 0;
    this.veil.hidden = true;
    this.onFiles([...(event.dataTransfer?.files ?? [])]);
  }
}
