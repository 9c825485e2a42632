/**
 * Something that is there once for all who need it: it is made for the first of them, and ended when the last one has
 * given it back.
 */
export class Shared<Thing> {
  private thing: Thing | null = null;
  private readonly borrowers = new Set<object>();

  constructor(private readonly end: (thing: Thing) => void) {}

  /** May be called more than once for a borrower, who gives back once. */
  lend(borrower: object, make: () => Thing): Thing {
    this.borrowers.add(borrower);
    return (this.thing ??= make());
  }

  /** Does nothing for who has not borrowed what is there now. */
  giveBack(borrower: object): void {
    if (this.borrowers.delete(borrower) && this.borrowers.size === 0) this.discard(this.thing);
  }

  /** Ends what has failed, if it is still lent: who borrows next gets another one. */
  discard(failed: Thing | null): void {
    if (failed === null || failed !== this.thing) return;
    this.thing = null;
    this.borrowers.clear();
    this.end(failed);
  }
}
