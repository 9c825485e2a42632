/** The model in the colours of the parts that it comes apart into. */
import type { Demo } from './demo.js';
import { drawModel, type ShownModel } from './model-picture.js';

/** A canvas with a slider below it that turns the model. */
class TurningModel {
  private readonly canvas = document.createElement('canvas');
  private readonly slider = document.createElement('input');
  private model: ShownModel | null = null;

  constructor(place: HTMLElement) {
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'The model in the colours of its parts');
    Object.assign(this.slider, { type: 'range', min: '0', max: '360', value: '40' });
    const label = document.createElement('label');
    label.append('Turn it ', this.slider);
    const frame = document.createElement('div');
    frame.append(this.canvas, label);
    place.append(frame);
    this.slider.addEventListener('input', () => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  show(model: ShownModel | null): void {
    this.model = model;
    this.draw();
  }

  private draw(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.canvas.width = Math.round(width * devicePixelRatio);
    this.canvas.height = Math.round(height * devicePixelRatio);
    const context = this.canvas.getContext('2d');
    if (!context || !this.model || width === 0) return;
    context.scale(devicePixelRatio, devicePixelRatio);
    drawModel(context, [width, height], this.model, (Number(this.slider.value) * Math.PI) / 180);
  }
}

export const clustering: Demo = {
  action: 'Cut into parts',
  fields: [
    { name: 'parts', title: 'Parts', kind: 'number', value: 6, least: 1, most: 20 },
    {
      name: 'segment',
      title: 'By',
      kind: 'choice',
      choices: { merge: 'foldability and shape', spectral: 'foldability alone' },
    },
  ],
  begin(place) {
    const picture = new TurningModel(place);
    let model: ShownModel | null = null;
    return {
      options: ({ parts, segment }) => ({
        parts: Number(parts),
        segment: segment as 'merge' | 'spectral',
        seed: 1,
      }),
      clear: () => picture.show((model = null)),
      take(event) {
        if (event.type === 'model') {
          const { vertices, faces } = event;
          picture.show((model = { vertices, faces, labels: null }));
          return { words: `${faces.length / 3} faces; learning which belong together` };
        }
        if (event.type !== 'segmented' || !model) return {};
        picture.show({ ...model, labels: event.labels });
        const parts = new Set(event.labels).size;
        return { words: `${parts} parts, each in a colour of its own`, isDone: true };
      },
    };
  },
};
