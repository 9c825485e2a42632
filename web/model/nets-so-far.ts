import type { JobEvent, NetPicture } from './job.js';
import { stages, type Stage } from './stages.js';

/** A net that was found. */
export interface FoundNet {
  part: number;
  /** Null where nobody has told its shape: that of a body that another one is a copy of, or of a file. */
  net: NetPicture | null;
}

const isFlat = ({ overlapping }: NetPicture): boolean => !overlapping.includes(1);

/** The net with the part that its faces are in now; none if they are in several. */
function withinPart(found: FoundNet, labels: Int32Array): FoundNet[] {
  if (!found.net) return [found];
  const [first, ...others] = found.net.sources;
  const part = labels[first!];
  if (part === undefined || others.some((face) => labels[face] !== part)) return [];
  return [part === found.part ? found : { ...found, part }];
}

/** Whether both are nets of the same faces, or share some. */
function shareFaces(a: NetPicture, b: NetPicture): boolean {
  const faces = new Set(a.sources);
  return b.sources.some((face) => faces.has(face));
}

/**
 * The nets that a run has found so far, from what it tells. A `net` event says that a part has one, the `generation`
 * before it how that looks. A part may be searched again for other borders: its next net takes the place of the one
 * before, and of any other that had some of its faces. Some of them are only tried, such as that of a whole body, and
 * nobody says when they are rejected: at the end of the search nets stay that lie within one part, and what tried ones
 * had taken the place of comes back.
 */
export class NetsSoFar {
  private list: FoundNet[] = [];
  /** Those that were there before and lost faces to others. */
  private displaced: FoundNet[] = [];
  private labels: Int32Array | null = null;
  private isOver = false;
  /** Parts that have, or had, a net. */
  private readonly told = new Set<number>();
  /** Parts whose present net lies there and was not said to be found. */
  private readonly untold = new Set<number>();
  /** Without overlaps, but not said to be found: whoever searches may not be content with them. */
  private waiting: { part: number; net: NetPicture }[] = [];

  /** In the order in which they were found. */
  get nets(): readonly FoundNet[] {
    return this.list;
  }

  /** Takes the next event in; whether the nets have changed. */
  follow(event: JobEvent): boolean {
    if (event.type === 'segmented') this.labels = event.labels;
    if (event.type === 'stage') return this.reach(event.stage);
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
    // Of a part that had a net before, the next one lies there as soon as it is shown.
    if (!shown && this.untold.delete(part)) return;
    this.land({ part, net: shown?.net ?? null });
  }

  private show(part: number, net: NetPicture): boolean {
    const own = this.list.filter((found) => found.part === part);
    const isOther = own.every((found) => found.net && !shareFaces(found.net, net));
    // A part that was told of and lost its net to others is not told of again.
    const isBetter = this.told.has(part) && !(isOther && own.length > 0);
    if (isBetter) {
      this.untold.add(part);
      this.land({ part, net });
    } else {
      this.waiting = this.waiting.filter((other) => !shareFaces(other.net, net));
      this.waiting.push({ part, net });
    }
    return isBetter;
  }

  private land(found: FoundNet): void {
    const { part, net } = found;
    const stays = (other: FoundNet): boolean =>
      other.net && net ? !shareFaces(other.net, net) : other.part !== part || net === null;
    this.displaced.push(...this.list.filter((other) => !stays(other)));
    this.list = [...this.list.filter(stays), found];
  }

  /** Whether the nets have changed with the end of the search. */
  private reach(stage: Stage): boolean {
    if (this.isOver || stages.indexOf(stage) <= stages.indexOf('search')) return false;
    this.isOver = true;
    const { displaced, labels, list } = this;
    this.displaced = [];
    if (!labels || list.length === 0) return false;
    const final = list.flatMap((found) => withinPart(found, labels));
    const faces = new Set(final.flatMap(({ net }) => (net ? [...net.sources] : [])));
    for (const found of displaced.reverse().flatMap((other) => withinPart(other, labels))) {
      const sources = found.net?.sources ?? [];
      if (sources.some((face) => faces.has(face)) || sources.length === 0) continue;
      for (const face of sources) faces.add(face);
      final.push(found);
    }
    this.list = final;
    return final.length !== list.length || final.some((found, i) => found !== list[i]);
  }
}
