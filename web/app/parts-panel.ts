import { merging, splitting } from '../model/edits.js';
import type { Edit, JobResult } from '../model/job.js';
import { partColour } from '../model/part-colours.js';
import { find, make } from './dom.js';

/** What a person asks for, and its name. */
export interface Change {
  edits: Edit[];
  /** To be read after "Undo: ". */
  words: string;
}

export interface PartsListener {
  /** These parts are chosen now, from 0; all others are not. */
  select(parts: number[]): void;
  change(change: Change): void;
  undo(): void;
}

/** Letters of a part's pieces and how many faces they have. */
function describe({ pieces }: JobResult, part: number): { letters: string; faces: number } {
  const own = pieces.filter((piece) => piece.part === part);
  return {
    letters: own.map(({ name }) => name).join(' '),
    faces: own.reduce((sum, { sources }) => sum + sources.length, 0),
  };
}

/** "part 3", "parts 1 and 2" */
function names(parts: number[]): string {
  const numbers = parts.map((part) => part + 1);
  if (numbers.length === 1) return `part ${numbers[0]}`;
  return `parts ${numbers.slice(0, -1).join(', ')} and ${numbers.at(-1)}`;
}

/** The parts of a result: choose some, split or merge them, and take that back. */
export class PartsPanel {
  /** Where the progress of a change is shown. */
  readonly progress = find('#parts-progress', HTMLElement);
  private readonly card = find('#parts-card', HTMLElement);
  private readonly list = find('#parts-list', HTMLElement);
  private readonly splitButton = find('#split', HTMLButtonElement);
  private readonly into = find('#split-into', HTMLInputElement);
  private readonly mergeButton = find('#merge', HTMLButtonElement);
  private readonly undoButton = find('#undo', HTMLButtonElement);
  private readonly selected = new Set<number>();
  private count = 0;
  private busy = false;

  constructor(private readonly listener: PartsListener) {
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
    this.count = result.parts;
    const parts = Array.from({ length: result.parts }, (_, part) => part);
    this.list.replaceChildren(...parts.map((part) => this.chip(result, part)));
    this.undoButton.textContent = undo === null ? 'Undo' : `Undo: ${undo}`;
    this.undoButton.hidden = undo === null;
    this.select(selected);
  }

  /** Chooses a part, or no longer. */
  toggle(part: number): void {
    if (this.busy || part >= this.count) return;
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

  private chip(result: JobResult, part: number): HTMLLIElement {
    const { letters, faces } = describe(result, part);
    const swatch = make('span', { className: 'part__swatch' });
    swatch.style.setProperty('--colour', partColour(part));
    const name = make('span', { textContent: `Part ${part + 1}, ` });
    const pieces = make('small', { textContent: `piece ${letters}` });
    const button = make('button', { type: 'button', className: 'part' }, swatch, name, pieces);
    button.title = `${faces} faces`;
    button.addEventListener('click', () => this.toggle(part));
    return make('li', {}, button);
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
    [...this.list.querySelectorAll('button')].forEach((button, part) => {
      button.setAttribute('aria-pressed', String(this.selected.has(part)));
    });
    this.show();
    this.listener.select(this.chosen);
  }

  private get chosen(): number[] {
    return [...this.selected].sort((a, b) => a - b);
  }

  private show(): void {
    const { size } = this.selected;
    this.splitButton.textContent = size > 1 ? 'Split these parts' : 'Split this part';
    this.mergeButton.textContent = size > 2 ? `Merge these ${size}` : 'Merge these two';
    const disable = (button: HTMLButtonElement, disabled: boolean): void =>
      button.setAttribute('aria-disabled', String(this.busy || disabled));
    disable(this.splitButton, size < 1 || !this.into.checkValidity());
    disable(this.mergeButton, size < 2);
    disable(this.undoButton, false);
  }

  private split(): void {
    const parts = this.chosen;
    const into = this.into.valueAsNumber;
    const edits = parts.map((part) => splitting(part, into));
    this.listener.change({ edits, words: `split of ${names(parts)}` });
  }

  private merge(): void {
    const parts = this.chosen;
    this.listener.change({ edits: [merging(parts)], words: `merging of ${names(parts)}` });
  }
}
