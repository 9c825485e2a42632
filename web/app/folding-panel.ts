import type { Piece } from '../model/job.js';
import { tempoFor, secondOf, timeAt, type Tempo } from '../model/tempo.js';
import { doubts, folded, joiningLetters } from './folding-words.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Ms of a frame at most: after a pause, as in the background, it goes on where it was. */
const longestFrame = 100;

/**
 * A slider and a button that unfold the model into its pieces and fold them up again. Nothing moves
 * until one of them is used.
 */
export class FoldingPanel extends Panel {
  private readonly bar = this.find('#folding', HTMLElement);
  private readonly slider = this.find('#folding-time', HTMLInputElement);
  private readonly button = this.find('#folding-play', HTMLButtonElement);
  private readonly words = this.find('#folding-words', HTMLOutputElement);
  private readonly note = this.find('#folding-note', HTMLElement);
  private pieces: readonly Piece[] = [];
  /** Of the pieces in the order of their joining; null until the model is first unfolded. */
  private letters: string[] | null = null;
  private tempo: Tempo = tempoFor(1);
  private playing = false;
  private lastFrame = 0;
  /** Finer than the slider's steps. */
  private time = 1;

  /** @param onTime is told how far the pieces shall be, from 0 (flat) to 1 (the model) */
  constructor(
    place: StudioPlace,
    private readonly onTime: (time: number) => void,
  ) {
    super(place);
    this.slider.addEventListener('input', () => this.show(this.slider.valueAsNumber));
    this.button.addEventListener('click', () => (this.playing ? this.pause() : this.play()));
    place.life.addEventListener('abort', () => this.pause());
  }

  /** Offers to unfold the model that is shown into these pieces. */
  offer(pieces: readonly Piece[]): void {
    this.pieces = pieces;
    this.letters = null;
    this.tempo = tempoFor(pieces.length);
    this.note.textContent = doubts(pieces);
    this.note.hidden = this.note.textContent === '';
    this.bar.hidden = false;
    this.show(1);
  }

  /** Takes the same pieces with other names. */
  rename(pieces: readonly Piece[]): void {
    if (this.bar.hidden) return;
    this.pieces = pieces;
    this.letters = null;
    this.note.textContent = doubts(pieces);
    this.go(this.time);
  }

  /** Takes the offer back. */
  clear(): void {
    this.pause();
    this.bar.hidden = this.note.hidden = true;
  }

  /** For a page that cannot show it. */
  remove(): void {
    this.bar.remove();
    this.note.remove();
  }

  /** Goes to a time, and stays there; nothing happens where there is nothing to fold. */
  show(time: number): void {
    if (this.bar.hidden) return;
    this.pause();
    this.go(time);
  }

  private go(time: number): void {
    this.time = time;
    this.slider.value = String(time);
    // Not with the result, which has enough to do for one frame.
    if (time < 1) this.letters ??= joiningLetters(this.pieces);
    const words = folded(time, this.letters ?? []);
    if (words !== this.words.textContent) {
      this.words.textContent = words;
      this.slider.setAttribute('aria-valuetext', words);
    }
    this.onTime(time);
  }

  private play(): void {
    if (this.time >= 1) this.go(0);
    this.playing = true;
    this.button.textContent = 'Pause';
    this.lastFrame = performance.now();
    requestAnimationFrame(this.frame);
  }

  private pause(): void {
    this.playing = false;
    this.button.textContent = 'Play';
  }

  private readonly frame = (now: number): void => {
    if (!this.playing) return;
    const seconds = Math.min(Math.max(now - this.lastFrame, 0), longestFrame) / 1000;
    this.lastFrame = now;
    this.go(timeAt(this.tempo, secondOf(this.tempo, this.time) + seconds));
    if (this.time >= 1) this.pause();
    else requestAnimationFrame(this.frame);
  };
}
