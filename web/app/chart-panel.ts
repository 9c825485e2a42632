import type { JobEvent } from '../model/job.js';
import { drawFitness } from '../view/fitness-chart.js';
import { FitnessHistory } from '../view/fitness-history.js';
import { Redraw } from '../view/redraw.js';
import { find } from './dom.js';

/** Ms between two drawings: events come no faster. */
const interval = 100;

/** Best fitness of the parts over the generations. */
export class ChartPanel {
  private readonly svg = find('#chart', SVGSVGElement);
  private history = new FitnessHistory();
  private readonly redraw = new Redraw(() => drawFitness(this.svg, this.history), interval);

  constructor() {
    new ResizeObserver(() => this.redraw.request()).observe(this.svg);
  }

  clear(): void {
    this.history = new FitnessHistory();
    this.redraw.request();
  }

  follow(event: Extract<JobEvent, { type: 'generation' }>): void {
    this.history.add(event);
    this.redraw.request();
  }
}
