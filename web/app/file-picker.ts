import { isForField } from './dom.js';
import { droppedFiles } from './dropped-files.js';
import type { PickedFile } from './model-file.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

function hasFiles({ dataTransfer }: DragEvent): boolean {
  return dataTransfer?.types.includes('Files') ?? false;
}

/** Text that is dropped into a field belongs there; whatever else the browser would do, it leaves the page. */
function isForStudio(event: DragEvent): boolean {
  return hasFiles(event) || !isForField(event);
}

/** The files that were chosen in a field, which forgets them: choosing the same file again counts as a choice. */
export function pickedFiles(input: HTMLInputElement): PickedFile[] {
  const files = [...(input.files ?? [])].map((file) => ({ path: file.name, file }));
  input.value = '';
  return files;
}

/** Offers files chosen with the picker, and files and folders dropped anywhere on the studio's ground. */
export class FilePicker extends Panel {
  private readonly input = this.find('#file', HTMLInputElement);
  private readonly veil = this.find('#drop-veil', HTMLElement);
  /** Entered elements minus left ones: dragging over a child leaves its parent. */
  private depth = 0;

  constructor(
    place: StudioPlace,
    private readonly onFiles: (files: Promise<readonly PickedFile[]>) => void,
  ) {
    super(place);
    this.input.addEventListener('change', () => {
      const files = pickedFiles(this.input);
      if (files.length > 0) this.onFiles(Promise.resolve(files));
    });
    this.listen('dragenter', (event) => this.enter(event, 1));
    this.listen('dragleave', (event) => this.enter(event, -1));
    this.listen('dragover', (event) => {
      if (isForStudio(event)) event.preventDefault();
    });
    this.listen('drop', (event) => this.drop(event));
  }

  private listen(type: string, take: (event: DragEvent) => void): void {
    const { ground, life } = this.place;
    const listener = (event: Event): void => {
      if (event instanceof DragEvent) take(event);
    };
    ground.addEventListener(type, listener, { signal: life });
  }

  private enter(event: DragEvent, change: number): void {
    if (!hasFiles(event)) return;
    this.depth += change;
    this.veil.hidden = this.depth <= 0;
  }

  /** Whoever drops something on one of several studios goes on with that one. */
  private takeKeyboard(): void {
    const studio = this.find('.studio', HTMLElement);
    if (!studio.matches(':focus-within')) studio.focus({ preventScroll: true });
  }

  private drop(event: DragEvent): void {
    this.depth = 0;
    this.veil.hidden = true;
    if (!isForStudio(event)) return;
    event.preventDefault();
    this.takeKeyboard();
    this.onFiles(event.dataTransfer ? droppedFiles(event.dataTransfer) : Promise.resolve([]));
  }
}
