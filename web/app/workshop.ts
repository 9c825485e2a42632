import type { JobEvent, JobResult, Piece } from '../model/job.js';
import type { Vector } from '../model/vector.js';
import type { FoldedNets } from '../read/fold/folded-nets.js';
import { ChartPanel } from './chart-panel.js';
import { MatrixPanel } from './matrix-panel.js';
import type { ModelMarks } from './model-marks.js';
import { ModelPanel, type ModelListener } from './model-panel.js';
import { NetPanel } from './net-panel.js';
import { NetsPanel } from './nets-panel.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { RunPictures } from './run-pictures.js';

/** A model before it is unfolded. */
export interface Preview {
  name: string;
  vertices: Float32Array;
  faces: Int32Array;
  /** Parts in whose colours faces are marked; -1 is blank paper. */
  labels: Int32Array;
  /** Whether it is the model before with another number of triangles, or mended otherwise. */
  isSame: boolean;
  /** Whether what lies inside is seen through its faces. */
  isGlass: boolean;
}

/**
 * Where a run can be watched: the model, the nets so far and, for those who want to know how it works, its foldability,
 * the net under search and its fitness. When a result arrives, the model moves beside it and how it works below it.
 */
export class Workshop extends Panel {
  private readonly room = this.find('#workshop', HTMLElement);
  private readonly views = this.find('#workshop-views', HTMLElement);
  private readonly note = this.find('#workshop-note', HTMLElement);
  private readonly pictures = this.find('#pictures', HTMLElement);
  private readonly model: ModelPanel;
  private readonly matrix = new MatrixPanel(this.place);
  private readonly net = new NetPanel(this.place);
  private readonly chart = new ChartPanel(this.place);
  private readonly nets = new NetsPanel(this.place);
  private readonly how = this.find('#how', HTMLElement);
  /** Of the present run, or the last one. */
  private present = new RunPictures('');
  /** Those that the panels show. */
  private shownPictures: RunPictures | null = null;

  constructor(place: StudioPlace, listener: ModelListener) {
    super(place);
    this.model = new ModelPanel(place, listener);
  }

  /** Shows the room in which a run is watched. */
  set open(open: boolean) {
    this.room.hidden = !open;
  }

  /** Leaves the room to the model alone, or not. */
  set checking(checking: boolean) {
    this.room.toggleAttribute('data-check', checking);
  }

  /** Loads what the pictures need, for a run that will come. */
  prepare(): void {
    this.model.prepare();
  }

  /** Awaits a run; what is on the page stays until the first of its pictures comes. */
  begin(pictures: RunPictures): void {
    this.present = pictures;
    this.model.prepare();
  }

  /** Takes an event of the run in. */
  follow(event: JobEvent): void {
    const { present } = this;
    this.nets.follow(event);
    switch (event.type) {
      case 'model':
        this.enter();
        this.model.show(present, event);
        this.nets.begin(event);
        break;
      case 'learned':
        if (!event.matrix) break;
        present.matrix = event.matrix;
        this.matrix.show(event.matrix);
        break;
      case 'segmented':
        this.model.paint(event.labels);
        this.net.paint(event.labels);
        this.matrix.finish(present.matrix);
        break;
      case 'generation':
        present.fitness.add(event);
        this.net.follow(event);
        this.chart.update();
        break;
      case 'net':
        this.net.found(event.part);
        break;
      default:
        break;
    }
  }

  /** Shows a model that is not unfolded yet. */
  preview({ name, vertices, faces, labels, isSame, isGlass }: Preview): void {
    this.shownPictures = null;
    this.note.hidden = true;
    this.model.prepare();
    this.model.preview(name, { vertices, faces }, { keepsView: isSame, isGlass });
    this.model.paint(labels);
    if (isSame) return;
    this.views.prepend(this.model.figure);
    this.model.turn(true);
  }

  /** Shows a model that came with its nets, which is not unfolded. */
  exhibit(name: string, nets: FoldedNets): void {
    this.shownPictures = null;
    this.note.hidden = true;
    this.model.prepare();
    this.model.turn(false);
    this.model.exhibit(name, nets);
    this.views.prepend(this.model.figure);
  }

  /** Whether the panels show what belongs to a result. */
  shows(pictures: RunPictures): boolean {
    return this.shownPictures === pictures;
  }

  /** Clears away for a result: the panels move to it, with the pictures of its own run. */
  finish(pictures: RunPictures, result: JobResult): void {
    this.model.turn(false);
    this.model.finish(pictures, result);
    this.net.finish(result);
    if (!this.shows(pictures)) {
      this.matrix.finish(pictures.matrix);
      this.chart.show(pictures.fitness);
      this.shownPictures = pictures;
    }
    this.find('#result-model', HTMLElement).append(this.model.figure);
    this.find('#result-pictures', HTMLElement).append(this.pictures);
  }

  /** Colours the faces of the model by their parts again, after they were painted. */
  repaint(labels: Int32Array): void {
    this.model.paint(labels);
  }

  /** Takes the pieces of the result with other names; the pictures stay as they are. */
  rename(pieces: readonly Piece[]): void {
    this.model.rename(pieces);
  }

  /** Keeps what there is of a run that ended without a result, and says why it is no more. */
  stop(words: string): void {
    this.model.turn(false);
    this.note.textContent = words;
    this.note.hidden = !this.shows(this.present);
  }

  /** Folds or unfolds the finished model, from 0 (flat) to 1 (the model). */
  fold(time: number): void {
    this.model.fold(time);
  }

  /** Lights edges of the model, and looks at it from a direction unless that is null. */
  light(edges: Int32Array, from: Vector | null): void {
    this.model.light(edges, from);
  }

  /** Marks the edges that a building step is about, in place of those of another one. */
  markStep(marks: ModelMarks): void {
    this.model.markStep(marks);
  }

  /** Lets parts of the finished model stand out from all others, unless there are none. */
  select(parts: readonly number[]): void {
    this.model.select(parts);
  }

  /** Lights faces of the finished model, in place of those that were lit before. */
  lightFaces(faces: Int32Array): void {
    this.model.lightFaces(faces);
  }

  /** Draws the parts with hatches, or without. */
  hatch(hatched: boolean): void {
    this.model.hatch(hatched);
    this.net.hatch(hatched);
    this.nets.hatch(hatched);
  }

  private enter(): void {
    this.shownPictures = this.present;
    this.note.hidden = true;
    this.matrix.clear();
    this.net.clear();
    this.chart.show(this.present.fitness);
    this.views.prepend(this.model.figure);
    this.how.append(this.pictures);
    this.model.turn(true);
  }
}
