import { stepTimes } from '../model/choreography.js';
import type { Piece } from '../model/job.js';
import { FoldPlayer } from '../view/fold-player.js';
import { doubts, folded, joiningLetters, sameTime } from './folding-words.js';
import { FoldingTicks } from './folding-ticks.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/**
 * A slider and buttons that unfold the model into its pieces and fold them up again, and go from building step to
 * building step. Nothing moves until one of them is used.
 */
export class FoldingPanel extends Panel {
  private readonly bar = this.find('#folding', HTMLElement);
  private readonly slider = this.find('#folding-time', HTMLInputElement);
  private readonly button = this.find('#folding-play', HTMLButtonElement);
  private readonly back = this.find('#folding-back', HTMLButtonElement);
  private readonly on = this.find('#folding-on', HTMLButtonElement);
  private readonly words = this.find('#folding-words', HTMLOutputElement);
  private readonly ticks = new FoldingTicks(this.place, (time) => this.show(time));
  private readonly note = this.find('#folding-note', HTMLElement);
  private pieces: readonly Piece[] = [];
  /** Of the pieces in the order of their joining; null until the model is first unfolded. */
  private letters: string[] | null = null;
  /** Times of the building steps, ascending. */
  private steps: readonly number[] = [];
  /** Its time is finer than the slider's steps. */
  private readonly player = new FoldPlayer((time) => this.tell(time));

  /** @param onTime is told how far the pieces shall be, from 0 (flat) to 1 (the model) */
  constructor(
    place: StudioPlace,
    private readonly onTime: (time: number) => void,
  ) {
    super(place);
    this.slider.addEventListener('input', () => this.show(this.slider.valueAsNumber));
    this.button.addEventListener('click', () => {
      if (this.player.isPlaying) this.player.halt();
      else void this.play();
    });
    this.back.addEventListener('click', () => this.step(-1));
    this.on.addEventListener('click', () => this.step(1));
    this.slider.addEventListener('keydown', (event) => {
      if (event.key !== 'PageUp' && event.key !== 'PageDown') return;
      event.preventDefault();
      this.step(event.key === 'PageUp' ? 1 : -1);
    });
    place.life.addEventListener('abort', () => this.player.halt());
  }

  /** Offers to unfold the model that is shown into these pieces. */
  offer(pieces: readonly Piece[]): void {
    this.pieces = pieces;
    this.letters = null;
    this.player.begin(pieces.length);
    this.steps = stepTimes(pieces.length);
    this.ticks.offer(this.steps);
    this.note.textContent = doubts(this.told, pieces);
    this.note.hidden = this.note.textContent === '';
    this.bar.hidden = false;
    this.show(1);
  }

  /** Takes the same pieces with other names. */
  rename(pieces: readonly Piece[]): void {
    if (this.bar.hidden) return;
    this.pieces = pieces;
    this.letters = null;
    this.note.textContent = doubts(this.told, pieces);
    this.tell(this.player.time);
  }

  /** Takes the offer back. */
  clear(): void {
    this.player.halt();
    this.bar.hidden = this.note.hidden = true;
  }

  /** For a page that cannot show it. */
  remove(): void {
    this.bar.remove();
    this.note.remove();
  }

  /** Goes to a time, and stays there; nothing happens where there is nothing to fold. */
  show(time: number): void {
    if (!this.bar.hidden) this.player.jump(time);
  }

  private tell(time: number): void {
    this.slider.value = String(time);
    // Not with the result, which has enough to do for one frame.
    if (time < 1) this.letters ??= joiningLetters(this.pieces);
    const words = folded(this.told, time, this.letters ?? []);
    if (words !== this.words.textContent) {
      this.words.textContent = words;
      this.slider.setAttribute('aria-valuetext', words);
    }
    this.ticks.show(time);
    // A button with the keyboard on it must not go: at the ends it does nothing.
    this.back.setAttribute('aria-disabled', String(time <= 0));
    this.on.setAttribute('aria-disabled', String(time >= 1));
    this.onTime(time);
  }

  /** Goes to the next building step, or to the one before. */
  private step(by: 1 | -1): void {
    const isAhead = (time: number): boolean => (time - this.player.time) * by > sameTime;
    const ahead = this.steps.filter(isAhead);
    const next = by > 0 ? ahead[0] : ahead.at(-1);
    if (next !== undefined) this.show(next);
  }

  private async play(): Promise<void> {
    if (this.player.time >= 1) this.player.jump(0);
    const playing = this.player.play(1);
    this.button.textContent = this.told.folding.pause;
    await playing;
    if (!this.player.isPlaying) this.button.textContent = this.told.folding.play;
  }
}
