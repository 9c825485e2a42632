import { find, isForField } from './dom.js';

function hasFiles({ dataTransfer }: DragEvent): boolean {
  return dataTransfer?.types.includes('Files') ?? false;
}

/** Text that is dropped into a field belongs there; whatever else the browser would do, it leaves the page. */
function isForPage(event: DragEvent): boolean {
  return hasFiles(event) || !isForField(event);
}

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
    window.addEventListener('dragover', (event) => {
      if (isForPage(event)) event.preventDefault();
    });
    window.addEventListener('drop', (event) => this.drop(event));
  }

  private enter(event: DragEvent, change: number): void {
    if (!hasFiles(event)) return;
    this.depth += change;
    this.veil.hidden = this.depth <= 0;
  }

  private drop(event: DragEvent): void {
    this.depth = 0;
    this.veil.hidden = true;
    if (!isForPage(event)) return;
    event.preventDefault();
    this.onFiles([...(event.dataTransfer?.files ?? [])]);
  }
}
