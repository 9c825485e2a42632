import type { JobEvent, NetPicture } from './job.js';

/** A net that was found. */
export interface FoundNet {
  part: number;
  /** Null where nobody has told its shape: that of a body that another one is a copy of, or of a file. */
  net: NetPicture | null;
}

const isFlat = ({ overlapping }: NetPicture): boolean => !overlapping.includes(1);

/** Whether both are nets of the same faces, or share some. */
function shareFaces(a: NetPicture, b: NetPicture): boolean {
  const faces = new Set(a.sources);
  return b.sources.some((face) => faces.has(face));
}

/**
 * The nets that a run has found so far, from what it tells. A `net` event says that a part has one, the `generation`
 * before it how that looks. A part may be searched again for other borders: its next net takes the place of the one
 * before, and of any other that had some of its faces.
 */
export class NetsSoFar {
  private list: FoundNet[] = [];
  /** Parts that have, or had, a net. */
  private readonly told = new Set<number>();
  /** Without overlaps, but not said to be found: whoever searches may not be content with them. */
  private waiting: { part: number; net: NetPicture }[] = [];

  /** In the order in which they were found. */
  get nets(): readonly FoundNet[] {
    return this.list;
  }

  /** Takes the next event in; whether the nets have changed. */
  follow(event: JobEvent): boolean {
    if (event.type === 'net') {
      this.find(event.part);
      return true;
    }
    if (event.type !== 'generation' || !event.net || !isFlat(event.net)) return false;
    return this.show(event.part, event.net);
  }

  private find(part: number): void {
    this.told.add(part);
    const shown = this.waiting.find((other) => other.part === part);
    this.waiting = this.waiting.filter((other) => other !== shown);
    this.land({ part, net: shown?.net ?? null });
  }

  private show(part: number, net: NetPicture): boolean {
    const own = this.list.filter((found) => found.part === part);
    const isOther = own.every((found) => found.net && !shareFaces(found.net, net));
    // A part that was told of and lost its net to others is not told of again.
    const isBetter = this.told.has(part) && !(isOther && own.length > 0);
    if (isBetter) this.land({ part, net });
    else {
      this.waiting = this.waiting.filter((other) => !shareFaces(other.net, net));
      this.waiting.push({ part, net });
    }
    return isBetter;
  }

  private land(found: FoundNet): void {
    const { part, net } = found;
    const stays = (other: FoundNet): boolean =>
      other.net && net ? !shareFaces(other.net, net) : other.part !== part || net === null;
    this.list = [...this.list.filter(stays), found];
  }
}
