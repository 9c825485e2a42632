/** Things with numbers that are brought together into groups, two at a time. */
export class Groups {
  private readonly above: Int32Array;

  /** Each of `count` things alone. */
  constructor(count: number) {
    this.above = Int32Array.from({ length: count }, (_, i) => i);
  }

  /** A number that all of a group have in common, and no other group. */
  of(thing: number): number {
    const { above } = this;
    let top = thing;
    while (above[top] !== top) {
      // Halves the way for the next time.
      above[top] = above[above[top]!]!;
      top = above[top]!;
    }
    return top;
  }

  unite(a: number, b: number): void {
    this.above[this.of(a)] = this.of(b);
  }

  together(a: number, b: number): boolean {
    return this.of(a) === this.of(b);
  }
}
