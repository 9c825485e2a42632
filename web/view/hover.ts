/** Asks what is under the mouse, one question after the other: a mouse moves more often than there are answers. */
export class Hover {
  private isAsking = false;
  /** What to ask next. */
  private next: { x: number; y: number } | null = null;
  private isOver = false;

  constructor(private readonly post: (x: number, y: number) => void) {}

  ask(place: { x: number; y: number }): void {
    this.isOver = true;
    if (this.isAsking) this.next = place;
    else {
      this.isAsking = true;
      this.post(place.x, place.y);
    }
  }

  /** The mouse has left: answers that are still to come are of no use. */
  end(): void {
    this.isOver = false;
    this.next = null;
  }

  /** Takes note of an answer; whether it is of use. */
  answered(): boolean {
    this.isAsking = false;
    const { next } = this;
    this.next = null;
    if (next) this.ask(next);
    return this.isOver;
  }
}
