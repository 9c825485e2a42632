import type { FindingPlace } from '../model/finding-places.js';

/** Goes through places one after the other, and round again. */
export class PlaceWalk {
  private at = -1;

  /**
   * @param code names what the places are of
   * @param title says it
   * @param places one at least
   */
  constructor(
    readonly code: string,
    private readonly title: string,
    private readonly places: readonly FindingPlace[],
  ) {}

  /** Goes to the next place, or with -1 to the one before. */
  step(by: 1 | -1): FindingPlace {
    const { length } = this.places;
    // The first step leads to the first place, in either direction.
    this.at = this.at < 0 ? 0 : (this.at + by + length) % length;
    return this.places[this.at]!;
  }

  /** Whether there is another place to go to. */
  get isLong(): boolean {
    return this.places.length > 1;
  }

  /** What the places are of, and which of how many it is at. */
  get words(): string {
    return this.isLong ? `${this.title}: ${this.at + 1} of ${this.places.length}` : this.title;
  }
}
