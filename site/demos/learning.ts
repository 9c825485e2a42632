/** The foldability matrix while it is learned, and sorted by part in the end. */
import type { Demo } from './demo.js';
import { FlatPicture } from './flat-picture.js';

export const learning: Demo = {
  action: 'Learn',
  fields: [
    { name: 'runs', title: 'Attempts', kind: 'number', value: 400, least: 10, most: 4000 },
    { name: 'parts', title: 'Parts', kind: 'number', value: 6, least: 2, most: 15 },
    { name: 'seed', title: 'Seed', kind: 'number', value: 1, least: 0, most: 9999 },
  ],
  begin(place) {
    const picture = new FlatPicture(
      place,
      'Foldability matrix: darker pairs stay together more often',
    );
    return {
      options: ({ runs, parts, seed }) => ({
        runs: Number(runs),
        parts: Number(parts),
        seed: Number(seed),
      }),
      clear: () => picture.show({ type: 'nothing' }),
      take(event) {
        if (event.type !== 'learned') return {};
        if (event.matrix) picture.show({ type: 'matrix', matrix: event.matrix });
        if (!event.matrix?.blocks) return { words: `${event.runs} of ${event.of} attempts` };
        const { length } = event.matrix.blocks;
        const words = `${event.of} attempts, sorted by part: ${length} dark blocks, one for each part`;
        return { words, isDone: true };
      },
    };
  },
};
