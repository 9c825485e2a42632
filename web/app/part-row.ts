import type { JobResult } from '../model/job.js';
import type { PartName } from '../model/job-options.js';
import { partColour } from '../model/part-colours.js';
import type { Words } from '../words/words.js';
import { make } from './dom.js';

export interface PartRowListener {
  toggle(part: number): void;
  /** The name that a person has entered; empty for the letter. */
  rename(part: number, name: string): void;
}

/** A part in the list: a button that chooses it, and a field for its name. */
export class PartRow {
  readonly item: HTMLLIElement;
  private readonly button: HTMLButtonElement;
  private readonly pieces = make('small');
  private readonly field: HTMLInputElement;
  private name = '';
  /** Whether the field holds what was neither applied nor taken back. */
  private editing = false;
  /** Whether it holds a name that the part cannot have. */
  private refused = false;

  constructor(
    private readonly words: Words['parts'],
    private readonly part: number,
    private readonly listener: PartRowListener,
  ) {
    const swatch = make('span', { className: 'part__swatch' });
    swatch.style.setProperty('--colour', partColour(part));
    const label = make('span', {}, words.part(part + 1), this.pieces);
    this.button = make('button', { type: 'button', className: 'part' }, swatch, label);
    this.button.addEventListener('click', () => listener.toggle(part));
    this.field = this.nameField();
    this.item = make('li', { className: 'part-row' }, this.button);
  }

  /**
   * @param names those that parts have, or are about to
   * @param nameable whether the part can have a name now
   */
  show({ pieces }: JobResult, names: readonly PartName[], nameable: boolean): void {
    const own = pieces.filter((piece) => piece.part === this.part);
    const faces = own.reduce((sum, { sources }) => sum + sources.length, 0);
    this.name = names.find(({ part }) => part === this.part)?.name ?? '';
    const pieceNames = own.map(({ name }) => name);
    this.pieces.textContent = `, ${own.length > 0 ? this.words.pieces(pieceNames) : this.words.noNet}`;
    // The field says as much to those who see it.
    const isShown = own.length === 1 && own[0]!.name === this.name;
    this.pieces.classList.toggle('visually-hidden', isShown);
    this.button.title = this.words.faces(faces);
    if (!nameable) this.field.remove();
    else if (!this.field.parentNode) this.item.append(this.field);
    if (!this.editing && !this.refused) this.takeBack();
  }

  set pressed(pressed: boolean) {
    this.button.setAttribute('aria-pressed', String(pressed));
  }

  set locked(locked: boolean) {
    this.field.readOnly = locked;
  }

  /** Says of the field that what it holds was not applied. */
  refuse(): void {
    this.refused = true;
    this.field.setAttribute('aria-invalid', 'true');
  }

  /** What was refused belongs to another result. */
  forget(): void {
    if (this.refused) this.takeBack();
  }

  private nameField(): HTMLInputElement {
    const field = make('input', {
      type: 'text',
      className: 'part__name',
      placeholder: this.words.name,
      autocomplete: 'off',
      enterKeyHint: 'done',
    });
    field.setAttribute('aria-label', this.words.nameOf(this.part + 1));
    field.setAttribute('aria-describedby', 'name-fault');
    field.addEventListener('input', () => (this.editing = true));
    field.addEventListener('change', () => this.apply());
    field.addEventListener('keydown', ({ key, isComposing }) => {
      if (key === 'Escape' && !isComposing) this.takeBack();
    });
    return field;
  }

  /** At Enter, or when the keyboard leaves the field. */
  private apply(): void {
    // A name that was taken back is no change, whatever the browser says.
    if (!this.editing) return;
    this.editing = this.refused = false;
    this.field.removeAttribute('aria-invalid');
    this.listener.rename(this.part, this.field.value.trim());
  }

  private takeBack(): void {
    this.editing = this.refused = false;
    this.field.value = this.name;
    this.field.removeAttribute('aria-invalid');
  }
}
