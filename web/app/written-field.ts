/**
 * A field that is written in peace: what it holds counts once it is left, or Enter is pressed. Until then nothing else
 * changes it, and Escape takes it back and does nothing besides.
 */
export class WrittenField {
  private isWriting = false;
  /** What it shows while nobody writes. */
  private shown = '';

  /** @param apply takes what was written */
  constructor(
    private readonly field: HTMLInputElement,
    apply: (text: string) => void,
  ) {
    field.addEventListener('input', () => (this.isWriting = true));
    field.addEventListener('change', () => {
      if (!this.isWriting) return;
      this.isWriting = false;
      apply(field.value.trim());
    });
    field.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || event.isComposing || !this.isWriting) return;
      event.stopPropagation();
      this.forget();
    });
  }

  /** Shows a text, at once or when what is being written was taken back. */
  show(text: string): void {
    this.shown = text;
    if (!this.isWriting) this.field.value = text;
  }

  /** Takes back what is being written. */
  forget(): void {
    this.isWriting = false;
    this.field.value = this.shown;
  }
}
