import { make } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Below the slider of the folding: a tick for each building step. A press goes to the nearest one. */
export class FoldingTicks extends Panel {
  private readonly row = this.find('#folding-ticks', HTMLElement);
  private times: readonly number[] = [];

  constructor(place: StudioPlace, go: (time: number) => void) {
    super(place);
    this.row.addEventListener('click', ({ clientX }) => {
      const nearest = this.nearest(clientX);
      if (nearest !== undefined) go(nearest);
    });
  }

  /** Takes the times of the steps, from 0 to 1. */
  offer(times: readonly number[]): void {
    this.times = times;
    this.row.replaceChildren(
      ...times.map((time) => {
        const tick = make('span', { className: 'folding__tick' });
        tick.style.setProperty('--at', String(time));
        return tick;
      }),
    );
  }

  /** Marks the steps that are done at a time. */
  show(time: number): void {
    this.times.forEach((step, i) =>
      this.row.children[i]!.toggleAttribute('data-done', step <= time),
    );
  }

  private nearest(x: number): number | undefined {
    const away = this.times.map((_, i) => {
      const { left, width } = this.row.children[i]!.getBoundingClientRect();
      return Math.abs(left + width / 2 - x);
    });
    return this.times[away.indexOf(Math.min(...away))];
  }
}
