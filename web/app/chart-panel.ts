import { drawFitness } from '../view/fitness-chart.js';
import { FitnessHistory } from '../view/fitness-history.js';
import { Redraw } from '../view/redraw.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Ms between two drawings: events come no faster. */
const interval = 100;

/** Best fitness of the parts over the generations. */
export class ChartPanel extends Panel {
  private readonly svg = this.find('#chart', SVGSVGElement);
  private history = new FitnessHistory();
  private readonly redraw = new Redraw(() => drawFitness(this.svg, this.history), interval);

  constructor(place: StudioPlace) {
    super(place);
    const observer = new ResizeObserver(() => this.redraw.request());
    observer.observe(this.svg);
    place.life.addEventListener('abort', () => observer.disconnect());
  }

  /** Shows the fitness of a run. What is added to it is drawn when the panel is told so. */
  show(history: FitnessHistory): void {
    this.history = history;
    this.update();
  }

  update(): void {
    this.redraw.request();
  }
}
