import type { DocumentEdit } from '../model/document-edits.js';
import type { JobResult } from '../model/job.js';
import { hangTogether, type Neighbours, partNeighbours } from '../model/part-neighbours.js';
import { editWords } from './edit-words.js';
import { Panel } from './panel.js';
import { PartRow } from './part-row.js';
import type { StudioPlace } from './place.js';
import { onPress } from './press.js';
import { finishedParts } from './result-words.js';
import type { Store } from './store.js';

/** What a person asks for. */
export interface PartsListener {
  change(edits: readonly DocumentEdit[]): void;
  /** A part, from 1, shall have this name; its letter if it is empty. */
  rename(edit: Extract<DocumentEdit, { kind: 'name' }>): void;
  undo(): void;
  redo(): void;
}

/** The parts of a result: choose some, split, merge or name them, take that back or make it again. */
export class PartsPanel extends Panel {
  private readonly card = this.find('#parts-card', HTMLElement);
  private readonly list = this.find('#parts-list', HTMLElement);
  private readonly splitButton = this.find('#split', HTMLButtonElement);
  private readonly into = this.find('#split-into', HTMLInputElement);
  private readonly mergeButton = this.find('#merge', HTMLButtonElement);
  private readonly undoButton = this.find('#undo', HTMLButtonElement);
  private readonly redoButton = this.find('#redo', HTMLButtonElement);
  private readonly apart = this.find('#merge-apart', HTMLElement);
  private readonly fault = this.find('#name-fault', HTMLElement);
  private rows: PartRow[] = [];
  private neighbours: Neighbours = [];

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly listener: PartsListener,
  ) {
    super(place);
    onPress(this.splitButton, () => this.split());
    onPress(this.mergeButton, () => this.merge());
    onPress(this.undoButton, () => listener.undo());
    onPress(this.redoButton, () => listener.redo());
    this.into.addEventListener('input', () => this.show());
    store.on('work', () => this.show());
    store.on('selection', () => this.show());
  }

  /**
   * Takes the parts of another result.
   *
   * @param isRenaming it has the pieces of the one before, with other names
   */
  offer(result: JobResult, isRenaming: boolean): void {
    this.resize(result.parts);
    this.neighbours = partNeighbours(result);
    // Without all nets a job would go on to search, which a name must not.
    const nameable = finishedParts(result) === result.parts;
    const { names } = this.store;
    for (const row of this.rows) {
      // Why another name was refused stays to be read.
      if (!isRenaming) row.forget();
      row.show(result, names, nameable);
    }
    if (!isRenaming) this.fault.hidden = true;
    this.show();
  }

  /** Moves the keyboard here. */
  focus(): void {
    this.splitButton.focus({ preventScroll: true });
  }

  /** Says why a part, from 1, was not given a name. */
  refuse(part: number, reason: string): void {
    this.rows[part - 1]?.refuse();
    this.fault.textContent = reason;
    this.fault.hidden = false;
  }

  /** Rows of parts that stay are kept: the keyboard may be in one of them. */
  private resize(parts: number): void {
    for (const { item } of this.rows.splice(parts)) item.remove();
    while (this.rows.length < parts) {
      const row = new PartRow(this.told.parts, this.rows.length, {
        toggle: (part) => this.store.toggle(part),
        rename: (part, text) => this.rename(part, text),
      });
      this.rows.push(row);
      this.list.append(row.item);
    }
  }

  private rename(part: number, text: string): void {
    this.fault.hidden = true;
    this.listener.rename({ kind: 'name', part: part + 1, text });
  }

  private show(): void {
    const { busy, canMove, run, scene, undoable, redoable } = this.store;
    // What is chosen elsewhere are the nets of a file that is only looked at.
    const selection = scene === 'result' ? this.store.selection : [];
    const { length: count } = selection;
    this.card.setAttribute('aria-busy', String(busy));
    this.splitButton.textContent = this.told.parts.split(count);
    this.mergeButton.textContent = this.told.parts.merge(count);
    const disable = (button: HTMLButtonElement, disabled: boolean): void =>
      button.setAttribute('aria-disabled', String(disabled));
    disable(this.splitButton, busy || count < 1 || !this.into.checkValidity());
    const areApart = !hangTogether(this.neighbours, selection);
    this.apart.hidden = !areApart;
    disable(this.mergeButton, busy || count < 2 || areApart);
    this.rows.forEach((row, part) => {
      row.pressed = selection.includes(part);
      row.locked = busy;
    });
    const { before } = this.store;
    const { changes } = this.told;
    const offer = (
      button: HTMLButtonElement,
      told: typeof changes.undo,
      edits: typeof undoable,
    ): void => {
      const result = (button === this.undoButton && before) || run?.result;
      button.textContent = told(edits && result ? editWords(this.told, edits, result) : null);
      const hadFocus = button.matches(':focus');
      button.hidden = edits === null;
      if (edits === null && hadFocus) this.focus();
      disable(button, !canMove);
    };
    offer(this.undoButton, changes.undo, undoable);
    offer(this.redoButton, changes.redo, redoable);
  }

  private split(): void {
    const into = this.into.valueAsNumber;
    const { selection } = this.store;
    this.listener.change(selection.map((part) => ({ kind: 'split', part: part + 1, into })));
  }

  private merge(): void {
    const parts = this.store.selection.map((part) => part + 1);
    this.listener.change([{ kind: 'merge', parts }]);
  }
}
