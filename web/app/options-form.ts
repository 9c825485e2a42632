import { defaultOptions } from '../model/default-options.js';
import type { Orientation } from '../model/job-options.js';
import type { Settings } from '../model/options.js';
import { paperCalled, paperSizes, type PaperSize } from '../model/paper.js';
import { defaultSettings } from '../api/written-options.js';
import { make } from './dom.js';
import type { FacesField } from './faces-field.js';
import type { FieldValues } from './pending-settings.js';
import { fill } from './fill.js';
import { methodFields, paperFields } from './paper-fields.js';
import { FlapFields } from './flap-fields.js';
import type { MendFields } from './mend-fields.js';
import { MoreOptions } from './more-options.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { SizeFields } from './size-fields.js';

/** Values of fields, as text. */
export interface Preset {
  /** A number, or nothing or `auto` for what the shape says. */
  parts?: string;
  seed?: string;
  /** Name of a paper, or WxH in mm. */
  paper?: string;
  /** The most triangles; nothing for all, or what is proposed for a large model. */
  faces?: string;
}

const orientations: readonly Orientation[] = ['auto', 'portrait', 'landscape'];

function inches(length: number): string {
  return String(Math.round((length / 25.4) * 10) / 10);
}

function paperLabel({ name, width, height }: PaperSize): string {
  if (name.endsWith('in')) return `${inches(width)} × ${inches(height)} in`;
  if (name.includes('x')) return `${width} × ${height} mm`;
  return `${name} (${Math.round(width)} × ${Math.round(height)} mm)`;
}

function paperOption(size: PaperSize): HTMLOptionElement {
  return make('option', { value: size.name, textContent: paperLabel(size) });
}

/** The fields for parts and paper, those for the method, and the button that starts. */
export class OptionsForm extends Panel {
  private readonly form = this.find('#controls', HTMLFormElement);
  private readonly parts = this.find('#parts', HTMLInputElement);
  private readonly paper = this.find('#paper', HTMLSelectElement);
  private readonly orientation = this.find('#orientation', HTMLSelectElement);
  private readonly margin = this.find('#margin', HTMLInputElement);
  private readonly button = this.find('#unfold', HTMLButtonElement);
  private readonly more = new MoreOptions(this.place);
  readonly size = new SizeFields(this.place);
  private readonly flaps = new FlapFields(this.place);

  constructor(place: StudioPlace, onSubmit: () => void) {
    super(place);
    this.paper.replaceChildren(...paperSizes.map(paperOption));
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

  /** The field for the number of triangles. */
  get faces(): FacesField {
    return this.more.faces;
  }

  /** The fields for what is mended on request. */
  get mending(): MendFields {
    return this.more.mending;
  }

  /** Whether all fields make sense. */
  get isValid(): boolean {
    return this.form.matches(':valid');
  }

  /** Calls `listener` after every change of a field. */
  onChange(listener: () => void): void {
    for (const type of ['input', 'change']) this.form.addEventListener(type, listener);
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

  /** Fills in fields; a value that a field does not take is ignored. */
  preset({ parts, seed, paper, faces }: Preset): void {
    const size = paperCalled(paper ?? '');
    if (size) this.choosePaper(size);
    if (parts !== undefined) fill(this.parts, parts === 'auto' ? '' : parts);
    if (seed !== undefined) fill(this.more.seed, seed);
    if (faces !== undefined) this.more.faces.fill(faces);
    // As if a person had: what depends on the fields looks at them again.
    this.form.dispatchEvent(new Event('input'));
  }

  /** Fills in all fields with the settings of a document. */
  fillAll(settings: Settings): void {
    this.fillPaper(new Map([...paperFields(settings), ...methodFields(settings)]));
    this.more.faces.set(settings.faces);
    this.mending.set(settings);
  }

  /** Fills in fields by their ids; a kind of size comes before its number. */
  fillPaper(values: FieldValues): void {
    for (const [id, value] of values) {
      const field = this.find(`#${id}`, HTMLElement);
      const size = id === 'paper' ? paperCalled(value) : null;
      if (size) this.choosePaper(size);
      else if (field instanceof HTMLSelectElement) field.value = value;
      else if (field instanceof HTMLInputElement && field.type === 'checkbox') {
        field.checked = value === 'true';
      } else if (field instanceof HTMLInputElement) field.value = value;
      // As if a person had: what depends on the field looks at it again.
      field.dispatchEvent(new Event('change', { bubbles: true }));
    }
  }

  /** What the fields say now; null after showing the person the field that makes no sense. */
  read(): Settings | null {
    if (!this.form.reportValidity()) return null;
    return {
      // For whatever has no field here.
      ...defaultSettings(),
      ...this.more.read(),
      ...this.size.read(),
      ...this.flaps.read(),
      parts: this.parts.value === '' ? 'auto' : this.parts.valueAsNumber,
      paper: paperCalled(this.paper.value) ?? paperSizes[0]!,
      orientation: orientations.find((value) => value === this.orientation.value) ?? 'auto',
      margin: this.margin.value === '' ? defaultOptions.margin : this.margin.valueAsNumber,
    };
  }

  /** One of no common size is added to the list. */
  private choosePaper(size: PaperSize): void {
    const isListed = [...this.paper.options].some(({ value }) => value === size.name);
    if (!isListed) this.paper.append(paperOption(size));
    this.paper.value = size.name;
  }
}
