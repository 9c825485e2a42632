import { defaultOptions } from '../model/default-options.js';
import type { JobOptions, Orientation } from '../model/job.js';
import { paperSizes, type PaperSize } from '../model/paper.js';
import { find, make } from './dom.js';
import { FlapFields } from './flap-fields.js';
import { MoreOptions } from './more-options.js';
import { SizeFields } from './size-fields.js';

/** What the form asks for. */
export interface Wishes {
  job: JobOptions;
  paper: PaperSize;
}

const orientations: readonly Orientation[] = ['auto', 'portrait', 'landscape'];

function inches(length: number): string {
  return String(Math.round((length / 25.4) * 10) / 10);
}

function paperLabel({ name, width, height }: PaperSize): string {
  if (name.includes('x')) return `${inches(width)} × ${inches(height)} in`;
  return `${name} (${Math.round(width)} × ${Math.round(height)} mm)`;
}

/** The fields for parts and paper, those for the method, and the button that starts. */
export class OptionsForm {
  private readonly form = find('#controls', HTMLFormElement);
  private readonly parts = find('#parts', HTMLInputElement);
  private readonly paper = find('#paper', HTMLSelectElement);
  private readonly orientation = find('#orientation', HTMLSelectElement);
  private readonly margin = find('#margin', HTMLInputElement);
  private readonly button = find('#unfold', HTMLButtonElement);
  private readonly more = new MoreOptions();
  private readonly size = new SizeFields();
  private readonly flaps = new FlapFields();

  constructor(onSubmit: () => void) {
    const papers = paperSizes.map((size) =>
      make('option', { value: size.name, textContent: paperLabel(size) }),
    );
    this.paper.replaceChildren(...papers);
    this.paper.value = 'A4';
    this.margin.value = String(defaultOptions.margin);
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      onSubmit();
    });
    for (const field of this.form.querySelectorAll<HTMLInputElement>('[type=number]')) {
      field.addEventListener('input', () => {
        field.setAttribute('aria-invalid', String(!field.validity.valid));
      });
    }
  }

  /** Lets the button start a run. */
  set ready(ready: boolean) {
    this.button.disabled = !ready;
  }

  /** Words on the button. */
  set action(words: string) {
    this.button.textContent = words;
  }

  /** Puts all fields out of use. */
  close(): void {
    for (const field of this.form.querySelectorAll('input, select')) {
      field.setAttribute('disabled', '');
    }
  }

  /** Moves the keyboard to the button. */
  focus(): void {
    this.button.focus({ preventScroll: true });
  }

  /** What the fields say now; null after showing the person the field that makes no sense. */
  read(): Wishes | null {
    if (!this.form.reportValidity()) return null;
    const paper = paperSizes.find(({ name }) => name === this.paper.value) ?? paperSizes[0]!;
    const orientation = orientations.find((value) => value === this.orientation.value) ?? 'auto';
    const job: JobOptions = {
      // For whatever has no field here.
      ...defaultOptions,
      ...this.more.read(),
      ...this.size.read(),
      ...this.flaps.read(),
      parts: this.parts.value === '' ? defaultOptions.parts : this.parts.valueAsNumber,
      paperWidth: paper.width,
      paperHeight: paper.height,
      orientation,
      margin: this.margin.value === '' ? defaultOptions.margin : this.margin.valueAsNumber,
    };
    return { job, paper };
  }
}
