import { paperCalled, paperSizes } from '../model/paper.js';
import type { OptionsForm } from './options-form.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Where the paper that a person has chosen last is kept: it lies in the printer, whatever project is open. */
const memory = 'foldwright.paper';

/** The one that the form begins with. */
const usual = paperSizes.find(({ name }) => name === 'A4')!.name;

/** Remembers the paper that a person chooses, and offers it at the next visit. */
export class PaperHabit extends Panel {
  private readonly field = this.find('#paper', HTMLSelectElement);

  constructor(place: StudioPlace, form: OptionsForm) {
    super(place);
    this.field.addEventListener('change', ({ isTrusted }) => {
      // What a document fills in is no habit.
      if (isTrusted) this.keep();
    });
    const paper = this.kept();
    // The page that embeds the studio may have chosen one.
    if (paper && this.field.value === usual) form.preset({ paper });
  }

  private keep(): void {
    try {
      localStorage.setItem(memory, this.field.value);
    } catch {
      // Some browsers keep nothing; then it is chosen again.
    }
  }

  private kept(): string | null {
    try {
      const name = localStorage.getItem(memory) ?? '';
      return paperCalled(name) && name;
    } catch {
      return null;
    }
  }
}
