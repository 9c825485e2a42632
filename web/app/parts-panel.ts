import { merging, splitting } from '../model/edits.js';
import type { PartEdit, JobResult } from '../model/job.js';
import { hangTogether, type Neighbours, partNeighbours } from '../model/part-neighbours.js';
import { Panel } from './panel.js';
import { PartRow } from './part-row.js';
import type { StudioPlace } from './place.js';
import { finishedParts } from './result-words.js';

/** What a person asks for, and its name. */
export interface Change {
  edits: PartEdit[];
  /** To be read after "Undo: ". */
  words: string;
}

export interface PartsListener {
  /** These parts are chosen now, from 0; all others are not. */
  select(parts: number[]): void;
  change(change: Change): void;
  /** A part shall have this name; its letter if it is empty. */
  rename(part: number, name: string): unknown;
  undo(): void;
}

/** "part 3", "parts 1 and 2" */
export function partNumbers(parts: number[]): string {
  const numbers = parts.map((part) => part + 1);
  if (numbers.length === 1) return `part ${numbers[0]}`;
  return `parts ${numbers.slice(0, -1).join(', ')} and ${numbers.at(-1)}`;
}

/** The parts of a result: choose some, split, merge or name them, and take that back. */
export class PartsPanel extends Panel {
  /** Where the progress of a change is shown. */
  readonly progress = this.find('#parts-progress', HTMLElement);
  private readonly card = this.find('#parts-card', HTMLElement);
  private readonly list = this.find('#parts-list', HTMLElement);
  private readonly splitButton = this.find('#split', HTMLButtonElement);
  private readonly into = this.find('#split-into', HTMLInputElement);
  private readonly mergeButton = this.find('#merge', HTMLButtonElement);
  private readonly undoButton = this.find('#undo', HTMLButtonElement);
  private readonly apart = this.find('#merge-apart', HTMLElement);
  private readonly selected = new Set<number>();
  private readonly fault = this.find('#name-fault', HTMLElement);
  private rows: PartRow[] = [];
  private neighbours: Neighbours = [];
  private busy = false;

  constructor(
    place: StudioPlace,
    private readonly listener: PartsListener,
  ) {
    super(place);
    this.on(this.splitButton, () => this.split());
    this.on(this.mergeButton, () => this.merge());
    this.on(this.undoButton, () => listener.undo());
    this.into.addEventListener('input', () => this.show());
  }

  /**
   * Takes the parts of another result.
   *
   * @param undo what can be taken back, in words; null if nothing can
   * @param selected parts that are chosen at first
   */
  offer(result: JobResult, undo: string | null, selected: number[] = []): void {
    this.resize(result.parts);
    this.neighbours = partNeighbours(result);
    // Without all nets a job would go on to search, which a name must not.
    const nameable = finishedParts(result) === result.parts;
    for (const row of this.rows) row.show(result, nameable);
    this.fault.hidden = true;
    this.undoButton.textContent = undo === null ? 'Undo' : `Undo: ${undo}`;
    this.undoButton.hidden = undo === null;
    this.select(selected);
  }

  /** Chooses a part, or no longer. */
  toggle(part: number): void {
    if (this.busy || part >= this.rows.length) return;
    const others = [...this.selected].filter((other) => other !== part);
    this.select(this.selected.has(part) ? others : [...others, part]);
  }

  /** Whether a change is being made: until then there can be no other. */
  set changing(busy: boolean) {
    this.busy = busy;
    this.card.setAttribute('aria-busy', String(busy));
    this.show();
  }

  /** Moves the keyboard here. */
  focus(): void {
    this.splitButton.focus({ preventScroll: true });
  }

  /** Says why a name was not applied. */
  refuse(reason: string): void {
    for (const row of this.rows) row.refuse();
    this.fault.textContent = reason;
    this.fault.hidden = false;
  }

  /** The parts that are chosen, from 0. */
  get chosen(): number[] {
    return [...this.selected].sort((a, b) => a - b);
  }

  /** Rows of parts that stay are kept: the keyboard may be in one of them. */
  private resize(parts: number): void {
    for (const { item } of this.rows.splice(parts)) item.remove();
    while (this.rows.length < parts) {
      const row = new PartRow(this.rows.length, {
        toggle: (part) => this.toggle(part),
        rename: (part, name) => this.rename(part, name),
      });
      this.rows.push(row);
      this.list.append(row.item);
    }
  }

  private rename(part: number, name: string): void {
    this.fault.hidden = true;
    this.listener.rename(part, name);
  }

  /** A button that is not to be used keeps the keyboard's place all the same. */
  private on(button: HTMLButtonElement, action: () => void): void {
    button.addEventListener('click', () => {
      if (button.getAttribute('aria-disabled') !== 'true') action();
    });
  }

  private select(parts: number[]): void {
    this.selected.clear();
    for (const part of parts) this.selected.add(part);
    this.rows.forEach((row, part) => (row.pressed = this.selected.has(part)));
    this.show();
    this.listener.select(this.chosen);
  }

  private show(): void {
    const { size } = this.selected;
    this.splitButton.textContent = size > 1 ? 'Split these parts' : 'Split this part';
    this.mergeButton.textContent = size > 2 ? `Merge these ${size}` : 'Merge these two';
    const disable = (button: HTMLButtonElement, disabled: boolean): void =>
      button.setAttribute('aria-disabled', String(this.busy || disabled));
    disable(this.splitButton, size < 1 || !this.into.checkValidity());
    const areApart = !hangTogether(this.neighbours, this.chosen);
    this.apart.hidden = !areApart;
    disable(this.mergeButton, size < 2 || areApart);
    disable(this.undoButton, false);
    for (const row of this.rows) row.locked = this.busy;
  }

  private split(): void {
    const parts = this.chosen;
    const into = this.into.valueAsNumber;
    const edits = parts.map((part) => splitting(part, into));
    this.listener.change({ edits, words: `split of ${partNumbers(parts)}` });
  }

  private merge(): void {
    const parts = this.chosen;
    this.listener.change({ edits: [merging(parts)], words: `merging of ${partNumbers(parts)}` });
  }
}
