import { assemblySteps, type AssemblyStep } from '../model/assembly-steps.js';
import { flightTimes } from '../model/choreography.js';
import type { JobResult } from '../model/job.js';
import { DoneSteps } from './done-steps.js';
import { make } from './dom.js';
import { modelMarks, noMarks, type ModelMarks } from './model-marks.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { stepMarks, type MarksBySheet } from './step-marks.js';
import { stepWords } from './step-words.js';

/** What else shows a step. */
export interface StepListener {
  /** Marks its folds and cuts on the sheets; nothing is to be marked any more if there are none. */
  mark(marks: MarksBySheet): void;
  /** The same on the model. */
  markModel(marks: ModelMarks): void;
  /** Goes to the time of the folding at which the step is done. */
  show(time: number): void;
}

/** The steps by which the model is built, one for each piece: a press shows one of them, a tick says that it is done. */
export class StepsPanel extends Panel {
  private readonly card = this.find('#steps-card', HTMLDetailsElement);
  private readonly list = this.find('#steps', HTMLOListElement);
  private readonly count = this.find('#steps-count', HTMLElement);
  private readonly memory = new DoneSteps(() => localStorage);
  private result: JobResult | null = null;
  /** Those of the result that are done, from 0. */
  private done = new Set<number>();

  constructor(
    place: StudioPlace,
    private readonly listener: StepListener,
  ) {
    super(place);
    // Only then, because it takes some time and most people look at the sheets first.
    this.card.addEventListener('toggle', () => {
      if (this.card.open && this.list.childElementCount === 0) this.fill();
    });
  }

  /** Takes the pieces of another result. */
  offer(result: JobResult): void {
    this.result = result;
    this.done = this.memory.of(result.hash);
    this.list.replaceChildren();
    this.listener.markModel(noMarks);
    this.tell();
    if (this.card.open) this.fill();
  }

  private get pieces(): JobResult['pieces'] {
    return this.result?.pieces ?? [];
  }

  private fill(): void {
    const { result } = this;
    if (!result) return;
    const steps = assemblySteps(result.pieces);
    const items = steps.map((step, rank) => {
      const row = make(
        'div',
        { className: 'steps__row' },
        this.tick(step, rank),
        this.button(step, rank, stepWords(this.told, step, result)),
      );
      return make('li', {}, row);
    });
    this.list.replaceChildren(...items);
  }

  private tell(): void {
    const done = [...this.done].filter((step) => step < this.pieces.length).length;
    this.count.textContent = done > 0 ? this.told.steps.done(done, this.pieces.length) : '';
  }

  private tick(step: AssemblyStep, rank: number): HTMLElement {
    const box = make('input', { type: 'checkbox', checked: this.done.has(rank) });
    box.setAttribute('aria-label', this.told.steps.pieceDone(this.pieces[step.piece]!.name));
    box.addEventListener('change', () => {
      if (box.checked) this.done.add(rank);
      else this.done.delete(rank);
      if (this.result) this.memory.set(this.result.hash, rank, box.checked);
      this.tell();
    });
    return make('label', { className: 'steps__tick' }, box);
  }

  private button(step: AssemblyStep, rank: number, words: string): HTMLButtonElement {
    const letter = this.pieces[step.piece]!.name;
    const name = make('strong', { textContent: this.told.steps.piece(letter) });
    const button = make('button', { type: 'button', className: 'step' }, name, ` ${words}`);
    button.setAttribute('aria-pressed', 'false');
    button.addEventListener('click', () => this.press(button, step, rank));
    return button;
  }

  private press(button: HTMLButtonElement, step: AssemblyStep, rank: number): void {
    const pressed = button.getAttribute('aria-pressed') !== 'true';
    for (const other of this.list.querySelectorAll('button')) {
      other.setAttribute('aria-pressed', String(pressed && other === button));
    }
    this.listener.mark(pressed ? stepMarks(step, this.pieces) : new Map());
    this.listener.markModel(pressed && this.result ? modelMarks(step, this.result) : noMarks);
    if (pressed) this.listener.show(flightTimes(rank, this.pieces.length).end);
  }
}
