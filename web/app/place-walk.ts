import type { FindingPlace } from '../model/finding-places.js';
import type { Words } from '../words/words.js';

function isSame(one: FindingPlace, other: FindingPlace | undefined): boolean {
  if (one.edge) return one.edge.modelEdge === other?.edge?.modelEdge;
  return one.piece === other?.piece;
}

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

  /** The same walk through the places that a change has left; null if there are none. */
  resumed(title: string, places: readonly FindingPlace[]): PlaceWalk | null {
    if (places.length === 0) return null;
    const walk = new PlaceWalk(this.code, title, places);
    const same = places.findIndex((place) => isSame(place, this.places[this.at]));
    // The one after a place that is gone is the next.
    walk.at = same < 0 ? Math.min(this.at, places.length) - 1 : same;
    return walk;
  }

  /** Whether there is another place to go to. */
  get isLong(): boolean {
    return this.places.length > 1;
  }

  /** What the places are of, and which of how many it is at. */
  wordsIn({ edges }: Words): string {
    const number = Math.max(this.at, 0) + 1;
    return this.isLong ? edges.place(this.title, number, this.places.length) : this.title;
  }
}
