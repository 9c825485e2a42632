import type { Inspection } from '../api/inspect.js';
import { JobError } from '../core/job-error.js';
import { extentsOf } from '../model/bounds.js';
import { isTiny } from '../model/components.js';
import { mostFaces, proposedFaces, usualFaces } from '../model/face-numbers.js';
import type { Message } from '../model/message.js';
import type { Settings } from '../model/options.js';
import { isUnmended } from './check-words.js';
import type { ChosenModel } from './model-file.js';
import {
  QuickLooks,
  type Aspect,
  type Looker,
  type OpenLooker,
  type Wishes,
} from './quick-looks.js';

/** Simplified models that are kept, so that going back to one costs nothing. */
const mostKept = 8;

/** The engine refuses to search nets of so many faces, and says how many there are. */
export const tooManyFaces = 'too-many-faces';

/** Triangles that a flat drawing has at most, as it is made in the page. */
const mostOutlined = 2 * usualFaces;

/** A model is first looked at as it is: what can be mended of it is then known. */
const unmended = { repair: 'on', fillHoles: 'off', inside: 'keep', crossing: 'keep' } as const;

const keyOf = ({ faces, up, repair, fillHoles, inside, crossing }: Aspect): string =>
  `${faces} ${up} ${repair} ${fillHoles} ${inside} ${crossing}`;

/** Holes that can be filled, how many of them are small, and what that means: in percent of the model's length. */
export interface FillableHoles {
  count: number;
  small: number;
  smallPercent: number;
}

const faceCount = ({ model }: Inspection): number => model.faces.length / 3;

/** The number of faces of a model that the engine refuses to show whole; 0 for any other failure. */
function refusedFaces(error: unknown): number {
  if (!(error instanceof JobError) || error.code !== tooManyFaces) return 0;
  return Number(error.params['faces']) || 0;
}

/**
 * A chosen model before it is unfolded: what it is, and what a number of triangles makes of it. It asks the engine
 * and ends what is not needed any more.
 */
export class Check {
  private readonly looks = new Map<string, Inspection>();
  /** Of the present up: the look with fewest triangles so far. */
  private coarsest: Inspection | null = null;
  private up: Aspect['up'] = 'guess';
  private first: Inspection | null = null;
  private shownLook: Inspection | null = null;
  private count = 0;
  private wantedNets: Settings['nets'] = 'new';
  private abort = new AbortController();
  private isWorking = false;
  /** Of the look that is shown or on its way; null if nobody has asked for one. */
  private asked: string | null = null;
  /** Whether a person has asked for a number of triangles. */
  private isAsked = false;

  private readonly quick: QuickLooks;

  /**
   * @param looker has the model open
   * @param onChange is called after every change
   */
  constructor(
    readonly model: ChosenModel,
    looker: Looker,
    open: OpenLooker,
    private readonly onChange: () => void,
  ) {
    this.quick = new QuickLooks(looker, open);
  }

  /** Name of the file that is the model; until it was read, by what the files are called. */
  get name(): string {
    return this.first?.file ?? this.model.name;
  }

  /** The model as it was seen last; null until it was read. */
  get look(): Inspection | null {
    return this.shownLook;
  }

  /** A look at the model that is quick to draw; null until there is one. */
  get outline(): Inspection | null {
    const { coarsest } = this;
    return coarsest && faceCount(coarsest) <= mostOutlined ? coarsest : null;
  }

  /** Whether another look is on its way. */
  get working(): boolean {
    return this.isWorking;
  }

  /** Triangles of the model when it is not simplified. */
  get faces(): number {
    return this.count;
  }

  /** Whether nets can be searched of the model as it is. */
  get isSearchable(): boolean {
    return this.count <= mostFaces;
  }

  /** How many triangles are proposed; null where the model is fine as it is, or a person has asked for a number. */
  get proposal(): number | null {
    return this.count > usualFaces && !this.isAsked ? proposedFaces : null;
  }

  /** What was repaired and what cannot be, of the model as it was seen last. */
  get repairs(): Inspection['repairs'] {
    return this.shownLook?.repairs ?? [];
  }

  /** Separate bodies of the model as it was seen last. */
  get bodies(): number {
    return this.shownLook?.components.length ?? 0;
  }

  /** How many of them are tiny. */
  get tinyBodies(): number {
    return this.shownLook ? tinyComponents(this.shownLook).size : 0;
  }

  /** Per face of the present look: 0 for those of tiny bodies, -1 for all others. */
  get tinyFaces(): Int32Array {
    if (!this.shownLook) return new Int32Array();
    const tiny = tinyComponents(this.shownLook);
    return this.shownLook.componentOfFaces.map((component) => (tiny.has(component) ? 0 : -1));
  }

  /** Holes of the model as it is; null without any. */
  get holes(): FillableHoles | null {
    const params = this.first?.repairs.find(({ code }) => code === 'open-holes')?.params;
    if (!params) return null;
    const [count, small] = [Number(params['count']), Number(params['small'])];
    return { count, small, smallPercent: Number(params['small_percent']) };
  }

  /** Bodies that lie inside others, left out or not; some only do once holes are filled. */
  get innerBodies(): number {
    return Math.max(innerBodiesOf(this.first), innerBodiesOf(this.shownLook));
  }

  /** Whether bodies run through each other that could be made one, or were. */
  get canUnite(): boolean {
    return isUnitable(this.first) || isUnitable(this.shownLook);
  }

  /** Pieces of the nets that the file brings along; 0 if it has none. */
  get fileNets(): number {
    return this.first?.fileNets ?? 0;
  }

  /** Whether these are to be kept. */
  get nets(): Settings['nets'] {
    return this.wantedNets;
  }

  /** Keeps the nets of the file, or has new ones made. */
  choose(nets: Settings['nets']): void {
    this.wantedNets = nets;
    this.onChange();
  }

  /** Whether someone should look before nets are searched. */
  get hasToDecide(): boolean {
    const isLarge = this.proposal !== null;
    // Large holes may well be meant: the lamp shade is to stay open.
    const canBeMended = this.innerBodies > 0 || (this.holes?.small ?? 0) > 0;
    const hasFaults = this.tinyBodies > 0 || this.first?.repairs.some(isUnmended) === true;
    return isLarge || this.fileNets > 0 || canBeMended || hasFaults;
  }

  /**
   * Reads the model as it is, whatever number of triangles is asked for. Rejects with a `JobError` for one that
   * cannot be read, and with the signal's reason after an abort.
   */
  async begin({ faces, up }: Wishes, signal: AbortSignal): Promise<void> {
    this.isAsked = faces !== 'off';
    const whole: Aspect = { faces: 'off', up, ...unmended };
    this.asked = keyOf(whole);
    let refused = 0;
    const look = await this.inspect(whole, signal).catch((error: unknown) => {
      refused = refusedFaces(error);
      if (refused === 0) throw error;
      const proposed = { ...whole, faces: proposedFaces };
      this.asked = keyOf(proposed);
      return this.inspect(proposed, signal);
    });
    this.first = this.shownLook = look;
    this.count = Math.max(refused, faceCount(look));
  }

  /** Shows the model with so many triangles, instead of whatever look was on its way. */
  async show(aspect: Aspect): Promise<void> {
    const key = keyOf(aspect);
    if (key === this.asked) return;
    this.abort.abort();
    this.isWorking = false;
    this.asked = key;
    const kept = this.looks.get(key);
    if (kept) {
      this.shownLook = kept;
      this.onChange();
      return;
    }
    const { signal } = (this.abort = new AbortController());
    this.isWorking = true;
    this.onChange();
    try {
      const look = await this.inspect(aspect, signal);
      if (!signal.aborted) this.shownLook = look;
    } catch (error) {
      if (signal.aborted) return;
      // The run that follows tells what is wrong; until then the look before stays.
      if (!(error instanceof JobError)) throw error;
    } finally {
      if (!signal.aborted) {
        this.isWorking = false;
        this.onChange();
      }
    }
  }

  /** Ends all looks that are on their way. */
  stop(): void {
    this.abort.abort();
    this.quick.stop();
    if (this.isWorking) this.asked = null;
    this.isWorking = false;
  }

  private async inspect(aspect: Aspect, signal: AbortSignal): Promise<Inspection> {
    const look = await this.quick.inspect(aspect, this.count, signal);
    if (aspect.up !== this.up) this.coarsest = null;
    this.up = aspect.up;
    if (!this.coarsest || faceCount(look) < faceCount(this.coarsest)) this.coarsest = look;
    this.looks.set(keyOf(aspect), look);
    for (const key of this.looks.keys()) {
      if (this.looks.size <= mostKept) break;
      this.looks.delete(key);
    }
    return look;
  }
}

function innerBodiesOf(look: Inspection | null): number {
  const codes = ['inner-bodies', 'dropped-inner-bodies'];
  const told = look?.repairs.find(({ code }) => codes.includes(code));
  return Number(told?.params['count'] ?? 0);
}

function isUnitable(look: Inspection | null): boolean {
  const can = (message: Message): boolean =>
    message.code === 'united-bodies' || Number(message.params['unitable']) > 0;
  return look?.repairs.some(can) ?? false;
}

/** Numbers of the components that are tiny. */
function tinyComponents({ model, components }: Inspection): Set<number> {
  if (components.length < 2) return new Set();
  const side = Math.max(...extentsOf(model.vertices));
  return new Set(components.flatMap((component, i) => (isTiny(component, side) ? [i] : [])));
}
