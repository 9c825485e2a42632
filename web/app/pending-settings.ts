import { find } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What the fields of the form hold, by their ids. */
export type FieldValues = ReadonlyMap<string, string>;

type Field = HTMLInputElement | HTMLSelectElement;

/** What a field comes to: an empty one means what it shows in grey, and 5.0 is 5. */
function valueOf(field: Field): string {
  if (field instanceof HTMLSelectElement) return field.value;
  if (field.type === 'checkbox') return String(field.checked);
  const value = field.value || field.placeholder;
  return field.type === 'number' && value !== '' ? String(Number(value)) : value;
}

/** What a person calls a field, without the unit. */
function nameOf({ labels, id }: Field): string {
  return labels?.[0]?.textContent?.split(',')[0]?.trim() ?? id;
}

/** Marks the settings that differ from those that the result was made with, until they are applied. */
export class PendingSettings extends Panel {
  private readonly form = this.find('#controls', HTMLFormElement);
  private readonly notes = this.place.root.querySelectorAll<HTMLElement>('.pending');
  private applied: FieldValues | null = null;

  constructor(place: StudioPlace) {
    super(place);
    for (const type of ['input', 'change']) this.form.addEventListener(type, () => this.mark());
  }

  /** What the fields hold now. */
  read(): FieldValues {
    return new Map(this.fields().map((field) => [field.id, valueOf(field)]));
  }

  /** Compares the fields with these from now on; nothing is marked without any. */
  compareWith(applied: FieldValues | null): void {
    this.applied = applied;
    this.mark();
  }

  /** Brings the note above the result into view, with the keyboard at the button that applies them. */
  reveal(): void {
    for (const note of this.notes) {
      const button = note.querySelector('button');
      button?.focus({ preventScroll: true });
      button?.scrollIntoView({ block: 'center' });
    }
  }

  private fields(): Field[] {
    return [...this.form.querySelectorAll<Field>('input:not([type=file]), select')];
  }

  private mark(): void {
    const { applied } = this;
    const names: string[] = [];
    for (const field of this.fields()) {
      // What is hidden is not asked for now.
      const isUsed = field.closest('[hidden]') === null;
      const isPending = applied !== null && isUsed && applied.get(field.id) !== valueOf(field);
      field.toggleAttribute('data-pending', isPending);
      if (isPending) names.push(nameOf(field));
    }
    for (const note of this.notes) {
      note.hidden = names.length === 0;
      find(note, 'span', HTMLElement).textContent = this.told.choice.pending(
        this.told.speech.all(names),
      );
    }
  }
}
