import { secondOf, tempoFor, timeAt, type Tempo } from '../model/tempo.js';

/** Ms of a frame at most: after a pause, as in the background, it goes on where it was. */
const longestFrame = 100;

/** Moves a folding from where it is to another time, as fast as one can follow. */
export class FoldPlayer {
  private tempo: Tempo = tempoFor(1);
  private current = 1;
  /** Ends the present way. */
  private stop: (() => void) | null = null;

  /** @param show hears of every time on the way, from 0 (flat) to 1 (folded) */
  constructor(private readonly show: (time: number) => void) {}

  get time(): number {
    return this.current;
  }

  get isPlaying(): boolean {
    return this.stop !== null;
  }

  /** Takes another model, which is folded. */
  begin(pieces: number): void {
    this.halt();
    this.tempo = tempoFor(pieces);
    this.current = 1;
  }

  /** Goes to a time at once. */
  jump(time: number): void {
    this.halt();
    this.go(time);
  }

  /** Goes there by and by; ends when it is there, or is halted. */
  play(to: number): Promise<void> {
    this.halt();
    const target = secondOf(this.tempo, to);
    return new Promise((resolve) => {
      let last = performance.now();
      let request = 0;
      const end = (): void => {
        cancelAnimationFrame(request);
        this.stop = null;
        resolve();
      };
      const frame = (now: number): void => {
        const seconds = Math.min(Math.max(now - last, 0), longestFrame) / 1000;
        last = now;
        const here = secondOf(this.tempo, this.current);
        const left = target - here;
        if (Math.abs(left) <= seconds) {
          this.go(to);
          return end();
        }
        this.go(timeAt(this.tempo, here + Math.sign(left) * seconds));
        request = requestAnimationFrame(frame);
      };
      this.stop = end;
      request = requestAnimationFrame(frame);
    });
  }

  halt(): void {
    this.stop?.();
  }

  private go(time: number): void {
    this.current = time;
    this.show(time);
  }
}
