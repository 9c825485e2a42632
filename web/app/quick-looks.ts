import type { Inspection } from '../api/inspect.js';
import type { Session } from '../api/session.js';
import type { ModelFile, ModelFiles } from '../model/model-files.js';
import type { Settings } from '../model/options.js';
import { engineFile } from '../read/engine-file.js';
import { identity } from '../read/matrix.js';
import { bitsOfSingle, halfSpacing, largestOf } from '../read/precision.js';
import { Soup } from '../read/soup.js';

/** What is asked of a model before it is unfolded, whatever is mended of it. */
export type Wishes = Pick<Settings, 'faces' | 'up'>;

/** What decides how it looks then. */
export interface Aspect extends Wishes {
  /** As a person writes it. */
  repair: string;
  fillHoles: Settings['fill-holes'];
  inside: Settings['inside'];
  crossing: Settings['crossing'];
}

/** What can look at a model. */
export type Looker = Pick<Session, 'inspect'>;

/** Opens files to look at them. */
export type OpenLooker = (files: ModelFiles) => Promise<Looker>;

/** Simplifying a model takes about a second for 70,000 triangles; of those with more than this one makes a copy first. */
const largestQuick = 12_000;

/** Triangles of the copy: simplified further they look as those of the model itself do, in a tenth of a second. */
const copyFaces = 6000;

/** The copy must be finer than what is made of it. */
const finestOfCopy = copyFaces / 2;

/** What a copy of a model is made with. */
type Making = Omit<Aspect, 'faces'>;

/** A copy of a model for one choice of what is up and what is mended. */
interface Copy extends Making {
  opened: Promise<{
    looker: Looker;
    /** Of the model, as there is nothing to repair in the copy. */
    repairs: Inspection['repairs'];
  }>;
}

function madeAlike(one: Making, other: Making): boolean {
  const { up, repair, fillHoles, inside, crossing } = one;
  return (
    up === other.up &&
    repair === other.repair &&
    fillHoles === other.fillHoles &&
    inside === other.inside &&
    crossing === other.crossing
  );
}

/** A mesh as a file for the engine, exactly. */
function fileOf({ vertices, faces }: Inspection['model']): ModelFile {
  const soup = new Soup();
  const error = halfSpacing(largestOf(vertices), bitsOfSingle);
  soup.add({ positions: vertices, triangles: faces, error }, identity);
  return engineFile(soup);
}

/**
 * Shows what a number of triangles makes of a model while someone looks for the right one. Few triangles of a
 * large model are made from a coarser copy of it, which is quick: the run itself starts from the model, and may
 * place a corner otherwise.
 */
export class QuickLooks {
  private copy: Copy | null = null;
  private end = new AbortController();

  constructor(
    private readonly looker: Looker,
    private readonly open: OpenLooker,
  ) {}

  /**
   * Rejects as `Session.inspect` does. An abort ends the look, but not a copy that is being made for it.
   *
   * @param size triangles of the whole model; 0 if that is not known
   */
  async inspect(aspect: Aspect, size: number, signal: AbortSignal): Promise<Inspection> {
    const { faces, ...making } = aspect;
    if (size <= largestQuick || faces === 'off' || faces > finestOfCopy) {
      return this.looker.inspect(aspect, { signal });
    }
    const { looker, repairs } = await this.copyFor(making);
    // What was left as it is, is to stay so in the copy.
    const { repair } = making;
    return { ...(await looker.inspect({ faces, up: 'y', repair }, { signal })), repairs };
  }

  /** Frees the workers of what goes on. */
  stop(): void {
    this.end.abort();
    this.end = new AbortController();
  }

  private copyFor(making: Making): Copy['opened'] {
    const { copy: before } = this;
    if (before && madeAlike(before, making)) return before.opened;
    const copy: Copy = { ...making, opened: this.makeCopy(making) };
    this.copy = copy;
    copy.opened.catch(() => {
      if (this.copy === copy) this.copy = null;
    });
    return copy.opened;
  }

  private async makeCopy(making: Making): Copy['opened'] {
    const { signal } = this.end;
    const { model, repairs } = await this.looker.inspect(
      { faces: copyFaces, ...making },
      { signal },
    );
    return { looker: await this.open([fileOf(model)]), repairs };
  }
}
