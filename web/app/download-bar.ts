import { drawnFormats } from '../export/formats.js';
import type { SheetRange } from '../model/sheet-range.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { ResultWriter } from './result-writer.js';
import { saveFile } from './save-file.js';

/** The buttons that save the result, one for each format. */
export class DownloadBar extends Panel {
  private readonly bar = this.find('#downloads', HTMLElement);
  private writer: ResultWriter | null = null;

  constructor(
    place: StudioPlace,
    /** Called for a format that could not be written, with the reason if there is one to tell. */
    private readonly onFailure: (format: string, reason: string | null) => void,
    /** Which sheets are wanted. */
    private readonly chosen: () => SheetRange,
  ) {
    super(place);
    for (const button of this.bar.querySelectorAll<HTMLButtonElement>('[data-format]')) {
      button.addEventListener('click', () => void this.save(button));
    }
  }

  /** Saves what this one writes from now on. The one before is not needed any more. */
  offer(writer: ResultWriter): void {
    this.writer?.close();
    this.writer = writer;
  }

  private async save(button: HTMLButtonElement): Promise<void> {
    const { writer } = this;
    const format = drawnFormats.find((name) => name === button.dataset['format']);
    if (!writer || !format || button.getAttribute('aria-busy') === 'true') return;
    const obstacle = writer.obstacle(format);
    if (obstacle !== null) {
      return this.onFailure(format.toUpperCase(), this.told.optionFault(obstacle));
    }
    button.setAttribute('aria-busy', 'true');
    try {
      const { name, content, mediaType } = await writer.file(format, this.chosen());
      saveFile(name, content, mediaType);
    } catch (error) {
      console.error(error);
      this.onFailure(format.toUpperCase(), null);
    } finally {
      button.removeAttribute('aria-busy');
    }
  }
}
