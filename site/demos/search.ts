/** The net that is searched, and how good the best ones are, generation by generation. */
import { drawFitness } from '../../web/view/fitness-chart.js';
import { FitnessHistory } from '../../web/view/fitness-history.js';
import type { Demo } from './demo.js';
import { FlatPicture } from './flat-picture.js';

function chartIn(place: HTMLElement): SVGSVGElement {
  const chart = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  chart.setAttribute('role', 'img');
  chart.setAttribute('aria-label', 'Best fitness of each part over the generations');
  chart.classList.add('chart');
  place.append(chart);
  return chart;
}

export const search: Demo = {
  action: 'Search nets',
  fields: [
    {
      name: 'solver',
      title: 'Search',
      kind: 'choice',
      choices: { genetic: 'genetic, as published', tree: 'local, on trees' },
    },
    { name: 'parts', title: 'Parts', kind: 'number', value: 3, least: 1, most: 15 },
    { name: 'seed', title: 'Seed', kind: 'number', value: 1, least: 0, most: 9999 },
  ],
  begin(place) {
    const net = new FlatPicture(place, 'The net that is searched, overlapping faces in red');
    const chart = chartIn(place);
    let history = new FitnessHistory();
    return {
      options: ({ solver, parts, seed }) => ({
        solver: solver as 'genetic' | 'tree',
        parts: Number(parts),
        seed: Number(seed),
        // The search alone: making room for flaps comes after it.
        compact: 'off',
      }),
      clear() {
        history = new FitnessHistory();
        net.show({ type: 'nothing' });
        drawFitness(chart, history);
      },
      take(event) {
        if (event.type === 'done') {
          const { pieces } = event.result;
          return { words: `${pieces.length} nets, none with an overlap`, isDone: true };
        }
        if (event.type !== 'generation') return {};
        history.add(event);
        drawFitness(chart, history);
        const { part, generation, overlaps } = event;
        if (event.net) {
          const parts = new Int32Array(event.net.sources.length).fill(part);
          net.show({ type: 'net', net: event.net, parts, hatched: false });
        }
        return { words: `part ${part + 1}, generation ${generation}: ${overlaps} overlaps` };
      },
    };
  },
};
