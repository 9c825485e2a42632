import { describe, expect, it } from 'vitest';
import { ProgressWords } from '../../web/app/progress-words.js';
import type { TimedEvent } from '../../web/core/protocol.js';
import type { JobEvent } from '../../web/model/job.js';
import { PartsProgress } from '../../web/model/parts-progress.js';
import { english } from '../../web/words/en/index.js';

const segmented = (...labels: number[]): JobEvent & TimedEvent => ({
  type: 'segmented',
  labels: Int32Array.from(labels),
});
const generation = (part: number, overlaps: number): JobEvent & TimedEvent => {
  return { type: 'generation', part, generation: 1, best: -overlaps, overlaps, hyperbolic: 0 };
};
const net = (part: number): JobEvent & TimedEvent => ({ type: 'net', part, piece: part });

/** A net without overlaps, of these faces. */
const shown = (part: number, ...faces: number[]): JobEvent => {
  const sources = Int32Array.from(faces);
  const corners = new Float32Array(6 * faces.length);
  const overlapping = new Uint8Array(faces.length);
  return { ...generation(part, 0), net: { corners, sources, overlapping } } as JobEvent;
};

function following(events: JobEvent[]): (number | null)[] {
  const progress = new PartsProgress();
  return events.map((event) => {
    progress.follow(event);
    return progress.overlaps;
  });
}

describe('PartsProgress', () => {
  it('adds the best of all parts up once all were heard of, and never rises', () => {
    const sums = following([
      segmented(0, 1, 1),
      generation(0, 9),
      generation(1, 5),
      generation(0, 12),
      generation(1, 3),
      generation(0, 4),
      net(1),
      generation(1, 2),
      net(0),
    ]);
    expect(sums).toEqual([null, null, 14, 14, 12, 7, 4, 4, 0]);
  });

  it('tells nothing of parts that nobody has heard of', () => {
    expect(following([segmented(0, 1, 2), generation(0, 9), net(1)])).toEqual([null, null, null]);
    expect(following([generation(0, 9)])).toEqual([null]);
  });

  it('counts a part once, however many pieces it has', () => {
    const progress = new PartsProgress();
    for (const event of [segmented(0, 1), net(0), net(0)]) progress.follow(event);
    expect([progress.done, progress.parts]).toEqual([1, 2]);
  });

  it('counts a part that is cut in two once both halves have nets', () => {
    const progress = new PartsProgress();
    const events = [
      segmented(0, 0, 0, 1, 1),
      shown(0, 0, 1),
      net(0),
      shown(1, 3, 4),
      net(1),
      shown(0, 2),
      net(0),
      // Another try for all of it does not make it undone.
      shown(0, 0),
    ];
    const done = events.map((event) => {
      progress.follow(event);
      return progress.done;
    });
    expect(done).toEqual([0, 0, 0, 0, 1, 1, 2, 2]);
  });

  it('counts a part that gives faces to another one when that has its net, too', () => {
    const progress = new PartsProgress();
    const events = [segmented(0, 0, 1), shown(0, 0), net(0), shown(1, 1, 2), net(1)];
    for (const event of events.slice(0, 3)) progress.follow(event);
    expect(progress.done).toBe(0);
    for (const event of events.slice(3)) progress.follow(event);
    expect(progress.done).toBe(2);
  });
});

describe('ProgressWords', () => {
  it('tell parts and overlaps while parts are laid flat', () => {
    const words = new ProgressWords(english);
    const texts = [
      { type: 'stage', stage: 'search', progress: 0.5, seconds: 1 } as const,
      segmented(0, 1, 1),
      generation(0, 2),
      generation(1, 1),
      generation(0, 1),
      net(1),
      net(0),
    ].map((event) => {
      words.follow(event);
      return words.text;
    });
    expect(texts.slice(2)).toEqual([
      'Laying the parts flat: 0 of 2 parts done',
      'Laying the parts flat: 0 of 2 parts done, 3 overlaps left',
      'Laying the parts flat: 0 of 2 parts done, 2 overlaps left',
      'Laying the parts flat: 1 of 2 parts done, 1 overlap left',
      'Laying the parts flat: 2 of 2 parts done',
    ]);
  });
});
