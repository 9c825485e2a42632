import type { JobEvent, JobResult, Piece } from '../model/job.js';
import { ChartPanel } from './chart-panel.js';
import { find } from './dom.js';
import { MatrixPanel } from './matrix-panel.js';
import { ModelPanel } from './model-panel.js';
import { NetPanel } from './net-panel.js';

/**
 * Where a run can be watched: the model, its foldability, the net under search and its fitness.
 * When a result arrives, the model moves beside it and the other pictures below it.
 */
export class Workshop {
  private readonly room = find('#workshop', HTMLElement);
  private readonly views = find('#workshop-views', HTMLElement);
  private readonly note = find('#workshop-note', HTMLElement);
  private readonly pictures = find('#pictures', HTMLElement);
  private readonly model: ModelPanel;
  private readonly matrix = new MatrixPanel();
  private readonly net = new NetPanel();
  private readonly chart = new ChartPanel();
  private modelName = '';
  /** Whether the pictures are of the present run. */
  private open = false;

  /** @param onPick is told the part of the model that was clicked */
  constructor(onPick: (part: number) => void) {
    this.model = new ModelPanel(onPick);
  }

  /** Whether a run that ended without a result has left something to see. */
  get shown(): boolean {
    return !this.room.hidden;
  }

  /** Loads what the pictures need, for a run that will come. */
  prepare(): void {
    this.model.prepare();
  }

  /** Awaits a run; what is on the page stays until the first of its pictures comes. */
  begin(modelName: string): void {
    this.modelName = modelName;
    this.open = false;
    this.room.hidden = true;
    this.model.prepare();
  }

  /** Takes an event of the run in. */
  follow(event: JobEvent): void {
    switch (event.type) {
      case 'model':
        this.enter();
        this.model.show(this.modelName, event);
        break;
      case 'learned':
        if (event.matrix) this.matrix.show(event.matrix);
        break;
      case 'segmented':
        this.model.paint(event.labels);
        this.net.paint(event.labels);
        this.matrix.settle();
        break;
      case 'generation':
        this.net.follow(event);
        this.chart.follow(event);
        break;
      case 'net':
        this.net.found(event.part);
        break;
      default:
        break;
    }
  }

  /** Clears away for the result: the pictures move to it. */
  finish(result: JobResult): void {
    this.model.turn(false);
    this.model.finish(this.modelName, result);
    this.net.finish(result);
    find('#result-model', HTMLElement).append(this.model.figure);
    find('#result-pictures', HTMLElement).append(this.pictures);
    this.room.hidden = true;
  }

  /** Takes the pieces of the result with other names; the pictures stay as they are. */
  rename(pieces: readonly Piece[]): void {
    this.model.rename(pieces);
  }

  /** Keeps what there is of a run that ended without a result, and says why it is no more. */
  stop(words: string): void {
    this.model.turn(false);
    this.note.textContent = words;
    this.note.hidden = !this.open;
  }

  /** Folds or unfolds the finished model, from 0 (flat) to 1 (the model). */
  fold(time: number): void {
    this.model.fold(time);
  }

  /** Lets parts of the finished model stand out from all others, unless there are none. */
  select(parts: number[]): void {
    this.model.select(parts);
  }

  /** Draws the parts with hatches, or without. */
  hatch(hatched: boolean): void {
    this.model.hatch(hatched);
    this.net.hatch(hatched);
  }

  private enter(): void {
    this.open = true;
    this.note.hidden = true;
    this.matrix.clear();
    this.net.clear();
    this.chart.clear();
    this.views.append(this.model.figure, this.pictures);
    this.room.hidden = false;
    this.model.turn(true);
  }
}
