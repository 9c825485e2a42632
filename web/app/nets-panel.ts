import { areasOf } from '../model/face-areas.js';
import type { JobEvent, JobResult, Model } from '../model/job.js';
import { NetsSoFar, type FoundNet } from '../model/nets-so-far.js';
import { draftPiece } from '../view/draft-picture.js';
import { flatNet, unknownNet, type FlatNet } from '../view/flat-net.js';
import { openPicture } from '../view/picture.js';
import { Redraw } from '../view/redraw.js';
import { Panel } from './panel.js';
import { SteadyWords } from './steady-words.js';

/** Words are not longer for more nets and sheets than that. */
const many = 88;

/** Ms between two pictures: events come no faster. */
const interval = 100;

/**
 * The nets that a run has found so far, side by side; once every part has one, the sheets that could be printed then, while
 * nets get better. The words say which.
 */
export class NetsPanel extends Panel {
  private readonly words = new SteadyWords(this.find('#nets-words', HTMLElement));
  private readonly frame = this.find('#nets', HTMLElement);
  private readonly picture = openPicture(this.frame, this.place.life);
  private readonly redraw = new Redraw(() => this.draw(), interval);
  private nets = new NetsSoFar();
  private areas: Float64Array = new Float64Array();
  private labels: Int32Array = new Int32Array();
  /** Of the sheets that could be printed; null until there are any. */
  private draft: JobResult | null = null;
  private hatched = false;
  /** Nets that were laid flat once. */
  private flat = new WeakMap<FoundNet, FlatNet>();

  /** Begins anew for the model of a run. */
  begin(model: Pick<Model, 'faces'> & { vertices: ArrayLike<number> }): void {
    this.nets = new NetsSoFar();
    this.flat = new WeakMap();
    this.draft = null;
    this.areas = areasOf(model);
    this.labels = new Int32Array();
    const { netsToCome, netsFound, couldBePrinted } = this.told.pictures;
    this.words.keepRoomFor([netsToCome, netsFound(many), couldBePrinted(many)]);
    this.words.text = netsToCome;
    this.redraw.request();
  }

  follow(event: JobEvent): void {
    if (event.type === 'segmented') this.labels = event.labels;
    if (event.type === 'draft') {
      this.draft = event.result;
      this.words.text = this.told.pictures.couldBePrinted(event.result.sheets.length);
    } else {
      if (!this.nets.follow(event) || this.draft) return;
      this.words.text = this.told.pictures.netsFound(this.nets.nets.length);
    }
    this.redraw.request();
  }

  hatch(hatched: boolean): void {
    this.hatched = hatched;
    this.redraw.request();
  }

  private draw(): void {
    const { draft, hatched } = this;
    if (draft) {
      const pieces = draft.pieces.map(draftPiece);
      this.picture.post({ type: 'draft', sheets: draft.sheets, pieces, hatched });
      return;
    }
    const nets = this.nets.nets.map((found) => ({ ...this.lie(found), part: found.part }));
    const ink = getComputedStyle(this.frame).color;
    this.picture.post({ type: 'mat', nets, hatched, ink });
  }

  private lie(found: FoundNet): FlatNet {
    const before = this.flat.get(found);
    if (before) return before;
    const lying = found.net ? flatNet(found.net) : unknownNet(this.areaOf(found.part));
    this.flat.set(found, lying);
    return lying;
  }

  private areaOf(part: number): number {
    return this.areas.reduce(
      (sum, area, face) => (this.labels[face] === part ? sum + area : sum),
      0,
    );
  }
}
