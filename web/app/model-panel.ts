import type { JobResult, Piece } from '../model/job.js';
import type { Vector } from '../model/vector.js';
import { canFold, labelsOf, type FoldedNets } from '../read/fold/folded-nets.js';
import type { DrawingFailure } from '../view/drawing.js';
import type { Painted, Pointed } from '../view/model-message.js';
import { ownPlaces } from '../view/model-places.js';
import { modelView } from '../view/model-view.js';
import { BrushSwitch } from './brush-switch.js';
import { FoldingPanel } from './folding-panel.js';
import { LooksSwitch } from './looks-switch.js';
import type { ModelMarks } from './model-marks.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { RunPictures } from './run-pictures.js';

interface ShownModel {
  vertices: Float32Array | Float64Array;
  faces: Int32Array;
}

export interface ModelListener {
  /** The mouse is over a face of the model, or over none any more, or one was clicked. */
  point(pointed: Pointed): void;
  /** Faces were painted in the colour of a part; they are shown so until `paint` is called. */
  paint(painted: Painted): void;
}

/** The model in 3D, and when it is finished its folding. */
export class ModelPanel extends Panel {
  readonly figure = this.find('#model', HTMLElement);
  private readonly picture = this.find('#model-picture', HTMLElement);
  private readonly note = this.find('#model-note', HTMLElement);
  private readonly name = this.find('#model-name', HTMLElement);
  private readonly view = modelView(this.picture, ownPlaces, this.place.life, {
    onFailure: (failure) => this.excuse(failure),
    onPoint: (pointed) => this.listener.point(pointed),
    isPainting: () => this.brush.isOn,
    onPaint: (painted) => this.listener.paint(painted),
  });
  private readonly folding = new FoldingPanel(this.place, (time) =>
    this.view.post({ type: 'time', time }),
  );
  private readonly looks = new LooksSwitch(this.place, (message) => this.view.post(message));
  // Who paints parts has to see them.
  private readonly brush = new BrushSwitch(this.place, (isOn) => (this.looks.held = isOn));
  /** Of the run whose model is shown. */
  private run: RunPictures | null = null;

  constructor(
    place: StudioPlace,
    private readonly listener: ModelListener,
  ) {
    super(place);
  }

  /** Loads what draws, so that the page appears without it. */
  prepare(): void {
    void this.view.open();
  }

  /** Shows the model of a run as blank paper. */
  show(run: RunPictures, { vertices, faces }: ShownModel): void {
    this.name.textContent = run.modelName;
    this.run = run;
    this.folding.clear();
    this.brush.offered = false;
    this.looks.offer(null);
    this.view.post({ type: 'model', vertices, faces });
  }

  /** Shows a model before its run; seen from where it was seen if it is but simplified otherwise. */
  preview(
    name: string,
    { vertices, faces }: ShownModel,
    how: { keepsView: boolean; isGlass: boolean },
  ): void {
    this.name.textContent = name;
    this.run = null;
    this.folding.clear();
    this.brush.offered = false;
    this.view.post({ type: 'model', vertices, faces, ...how });
  }

  /** Shows a folded model as its file has it, which can be folded and not painted. */
  exhibit(name: string, nets: FoldedNets): void {
    const { model, pieces } = nets;
    this.preview(name, model, { keepsView: false, isGlass: false });
    this.looks.offer(null);
    this.paint(labelsOf(nets));
    if (!canFold(nets)) return;
    this.view.post({ type: 'folding', model, pieces: [...pieces] });
    this.folding.offer(pieces);
  }

  /** Shows the repaired model in its final colours; that of the same run only changes its colours. */
  finish(run: RunPictures, { model, labels, pieces, looks }: JobResult): void {
    if (this.run !== run) this.show(run, model);
    // A run that was stopped may have left faces in no piece: they stay blank, and could not fold with the others.
    const found = new Set(pieces.flatMap(({ sources }) => [...sources]));
    this.paint(labels.map((part, face) => (found.has(face) ? part : -1)));
    this.looks.offer(looks ?? null);
    if (found.size !== labels.length) return;
    this.view.post({ type: 'folding', model, pieces });
    this.brush.offered = true;
    this.folding.offer(pieces);
  }

  /** Takes the pieces of the finished model with other names; it stays as it is. */
  rename(pieces: readonly Piece[]): void {
    this.folding.rename(pieces);
  }

  /** Colours the faces by their parts. */
  paint(labels: Int32Array): void {
    this.view.post({ type: 'labels', labels });
  }

  /** Lights edges, and looks at the model from a direction unless that is null. */
  light(edges: Int32Array, from: Vector | null): void {
    this.view.post({ type: 'lights', edges, from });
  }

  /** Marks the edges that a building step is about, in place of those of another one. */
  markStep({ edges, kinds }: ModelMarks): void {
    this.view.post({ type: 'step', edges, kinds });
  }

  /** Lets parts stand out from all others, unless there are none. */
  select(parts: readonly number[]): void {
    this.view.post({ type: 'selected', parts });
  }

  /** Lights faces, in place of those that were lit before. */
  lightFaces(faces: Int32Array): void {
    this.view.post({ type: 'lit', faces });
  }

  hatch(hatched: boolean): void {
    this.view.post({ type: 'hatched', hatched });
  }

  /** Folds or unfolds the finished model, from 0 (flat) to 1 (the model). */
  fold(time: number): void {
    this.folding.show(time);
  }

  /** Turns slowly, unless the person would rather have things rest. */
  turn(turning: boolean): void {
    const wanted = turning && !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.view.post({ type: 'turning', turning: wanted });
  }

  private excuse(failure: DrawingFailure): void {
    const { broken, noWebGl } = this.told.pictures;
    this.picture.hidden = true;
    this.folding.remove();
    this.note.textContent = failure === 'impossible' ? noWebGl : broken;
    this.note.hidden = false;
  }
}
