import { assemblySteps, type AssemblyStep } from '../model/assembly-steps.js';
import { flightTimes } from '../model/choreography.js';
import type { Piece } from '../model/job.js';
import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { stepMarks, type MarksBySheet } from './step-marks.js';
import { stepWords } from './step-words.js';

/** What else shows a step. */
export interface StepListener {
  /** Marks its folds and cuts on the sheets; nothing is to be marked any more if there are none. */
  mark(marks: MarksBySheet): void;
  /** Goes to the time of the folding at which the step is done. */
  show(time: number): void;
}

/** The steps by which the model is built, one for each piece; a press shows one of them. */
export class StepsPanel extends Panel {
  private readonly card = this.find('#steps-card', HTMLDetailsElement);
  private readonly list = this.find('#steps', HTMLOListElement);
  private pieces: readonly Piece[] = [];

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
  offer(pieces: readonly Piece[]): void {
    this.pieces = pieces;
    this.list.replaceChildren();
    if (this.card.open) this.fill();
  }

  private fill(): void {
    const steps = assemblySteps(this.pieces);
    const items = steps.map((step, rank) => make('li', {}, this.button(step, rank)));
    this.list.replaceChildren(...items);
  }

  private button(step: AssemblyStep, rank: number): HTMLButtonElement {
    const letter = this.pieces[step.piece]!.name;
    const name = make('strong', { textContent: `Piece ${letter}:` });
    const words = ` ${stepWords(step, this.pieces)}`;
    const button = make('button', { type: 'button', className: 'step' }, name, words);
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
    if (pressed) this.listener.show(flightTimes(rank, this.pieces.length).end);
  }
}
