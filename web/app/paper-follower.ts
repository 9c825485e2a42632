import type { FinishedRun } from './finished-run.js';
import type { OptionsForm } from './options-form.js';
import { paperFields } from './paper-fields.js';
import type { FieldValues, PendingSettings } from './pending-settings.js';

/**
 * Lets the form say what edits make of sheets, size, flaps and numbers: what such an edit changes is filled in, and is
 * what the form is compared with. All else that a person has written there stays.
 */
export class PaperFollower {
  private run: Pick<FinishedRun, 'fields'> | null = null;
  private values: FieldValues = new Map();
  /** Of the run before its first edit. */
  private first: FieldValues = new Map();

  constructor(
    private readonly form: OptionsForm,
    private readonly settings: PendingSettings,
  ) {}

  /** Takes the run on the page: a new one, or the one before as it is after an edit. */
  follow(run: FinishedRun): void {
    const values = paperFields(run.settings);
    // A new run was made as the form said.
    if (this.run?.fields === run.fields) this.fill(values);
    else this.first = values;
    [this.run, this.values] = [run, values];
    const edited = [...values].filter(([id, value]) => this.first.get(id) !== value);
    this.settings.compareWith(new Map([...run.fields, ...edited]));
  }

  private fill(values: FieldValues): void {
    const differs = (id: string): boolean => this.values.get(id) !== values.get(id);
    // Another kind of size takes its number along.
    const isNew = (id: string): boolean => differs(id) || (id === 'size' && differs('sizing'));
    const changed = [...values].filter(([id]) => isNew(id));
    if (changed.length > 0) this.form.fillPaper(new Map(changed));
  }
}
