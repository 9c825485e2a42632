import { find } from './dom.js';
import { exportResult, type ExportInput } from './exporters.js';
import { saveFile } from './save-file.js';

/** The buttons that save the result, one for each format. */
export class DownloadBar {
  private readonly bar = find('#downloads', HTMLElement);
  private input: ExportInput | null = null;

  constructor(private readonly onFailure: (format: string) => void) {
    for (const button of this.bar.querySelectorAll('button')) {
      button.addEventListener('click', () => void this.save(button));
    }
  }

  /** Saves this result from now on. */
  offer(input: ExportInput): void {
    this.input = input;
  }

  private async save(button: HTMLButtonElement): Promise<void> {
    const { input } = this;
    const format = button.dataset['format'];
    if (!input || !format || button.getAttribute('aria-busy') === 'true') return;
    button.setAttribute('aria-busy', 'true');
    try {
      const { name, content, mediaType } = await exportResult(format, input);
      saveFile(name, content, mediaType);
    } catch (error) {
      console.error(error);
      this.onFailure(format.toUpperCase());
    } finally {
      button.removeAttribute('aria-busy');
    }
  }
}
