import type { Words } from '../words/words.js';
import { find } from './dom.js';
import type { StudioPlace } from './place.js';

/** A part of a studio: finds its elements in the studio's own markup. */
export class Panel {
  constructor(protected readonly place: StudioPlace) {}

  /** What it says to people. */
  protected get told(): Words {
    return this.place.words;
  }

  /** The element that `selector` names; without it the markup itself is broken. */
  protected find<E extends Element>(selector: string, type: new () => E): E {
    return find(this.place.root, selector, type);
  }
}
