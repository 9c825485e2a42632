/**
 * Draws soon after something asked for it: in the next frame, once for all that asked before, and
 * no sooner than `interval` ms after the drawing before.
 */
export class Redraw {
  private waiting = false;
  private lastTime = -Infinity;

  constructor(
    private readonly draw: () => void,
    private readonly interval = 0,
  ) {}

  request(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(this.frame);
  }

  private readonly frame = (now: number): void => {
    if (now - this.lastTime < this.interval) {
      requestAnimationFrame(this.frame);
      return;
    }
    this.waiting = false;
    this.lastTime = now;
    this.draw();
  };
}
