import type { ModelView } from '../view/model-view.js';
import { find } from './dom.js';

interface ShownModel {
  vertices: Float32Array | Float64Array;
  faces: Int32Array;
}

const noWebGl = 'This browser draws no 3D view, because it has no WebGL 2. All else works.';
const notLoaded = 'The 3D view could not be loaded. All else works.';

/**
 * The model in 3D. Its view loads when first needed, so that the page appears without it; whatever
 * was asked for until then is made up for.
 */
export class ModelPanel {
  readonly figure = find('#model', HTMLElement);
  private readonly canvas = find('#model-canvas', HTMLCanvasElement);
  private readonly note = find('#model-note', HTMLElement);
  private readonly name = find('#model-name', HTMLElement);
  private view: ModelView | null = null;
  private loading = false;
  private model: ShownModel | null = null;
  private labels: Int32Array | null = null;
  private hatched = false;
  private turning = false;

  /** Starts to load the view, for a model that will come. */
  prepare(): void {
    if (this.view || this.loading) return;
    const context = this.canvas.getContext('webgl2', { alpha: true, antialias: true });
    if (context) void this.load(context);
    else this.excuse(noWebGl);
  }

  /** Shows a model as blank paper. */
  show(name: string, model: ShownModel): void {
    this.name.textContent = name;
    this.model = model;
    this.labels = null;
    this.view?.setModel(model.vertices, model.faces);
  }

  /** Shows the repaired model in its final colours; the one on screen only changes its colours. */
  finish(name: string, model: ShownModel, labels: Int32Array): void {
    const same = this.model?.faces.length === model.faces.length;
    if (!same) this.show(name, model);
    this.paint(labels);
  }

  /** Colours the faces by their parts. */
  paint(labels: Int32Array): void {
    this.labels = labels;
    this.view?.setLabels(labels);
  }

  hatch(hatched: boolean): void {
    this.hatched = hatched;
    if (this.view) this.view.hatched = hatched;
  }

  /** Turns slowly, unless the person would rather have things rest. */
  turn(turning: boolean): void {
    this.turning = turning && !matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (this.turning) this.view?.turn();
    else this.view?.rest();
  }

  private async load(context: WebGL2RenderingContext): Promise<void> {
    this.loading = true;
    try {
      const { ModelView } = await import('../view/model-view.js');
      this.view = new ModelView(this.canvas, context);
    } catch (error) {
      console.warn(error);
      this.excuse(notLoaded);
      return;
    } finally {
      this.loading = false;
    }
    if (this.model) this.view.setModel(this.model.vertices, this.model.faces);
    if (this.labels) this.view.setLabels(this.labels);
    this.view.hatched = this.hatched;
    if (this.turning) this.view.turn();
  }

  private excuse(words: string): void {
    this.canvas.hidden = true;
    this.note.textContent = words;
    this.note.hidden = false;
  }
}
