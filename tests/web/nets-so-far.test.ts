/** Nets land when they are found, and better ones take their place. */
import { describe, expect, it } from 'vitest';
import type { JobEvent } from '../../web/model/job.js';
import { NetsSoFar } from '../../web/model/nets-so-far.js';
import { flatNet } from '../../web/view/flat-net.js';
import { namePlace } from '../../web/view/net-name.js';

const picture = (sources: number[], overlapping: number[] = []) => ({
  corners: new Float32Array(6 * sources.length),
  sources: Int32Array.from(sources),
  overlapping: Uint8Array.from(sources, (face) => (overlapping.includes(face) ? 1 : 0)),
});
const shown = (part: number, sources: number[], overlapping?: number[]): JobEvent => {
  const overlaps = overlapping?.length ?? 0;
  const net = picture(sources, overlapping);
  return { type: 'generation', part, generation: 1, best: -overlaps, overlaps, hyperbolic: 0, net };
};
const found = (part: number, piece = part): JobEvent => ({ type: 'net', part, piece });

/** Part and faces of all nets after some events. */
function netsAfter(...events: JobEvent[]): string[] {
  const nets = new NetsSoFar();
  for (const event of events) nets.follow(event);
  return nets.nets.map(({ part, net }) => `${part}: ${net ? net.sources.join(' ') : 'unknown'}`);
}

describe('NetsSoFar', () => {
  it('lets a net land when it is said to be found, as it looked last', () => {
    expect(netsAfter(shown(0, [0, 1], [1]), shown(0, [0, 1]))).toEqual([]);
    expect(netsAfter(shown(1, [2, 3]), shown(0, [0, 1]), found(0), found(1))).toEqual([
      '0: 0 1',
      '1: 2 3',
    ]);
  });

  it('lets a better net take the place of its part, and of those that lost faces to it', () => {
    const before = [shown(0, [0, 1]), found(0), shown(1, [2, 3]), found(1)];
    expect(netsAfter(...before, shown(1, [1, 2, 3]))).toEqual(['1: 1 2 3']);
    expect(netsAfter(...before, shown(1, [1, 2, 3]), shown(0, [0]))).toEqual(['1: 1 2 3', '0: 0']);
    expect(netsAfter(...before, shown(1, [2, 3], [2]))).toEqual(['0: 0 1', '1: 2 3']);
  });

  it('keeps all pieces of a part that was cut', () => {
    const halves = [shown(0, [0, 1]), shown(0, [2, 3]), found(0, 0), found(0, 1)];
    expect(netsAfter(...halves)).toEqual(['0: 0 1', '0: 2 3']);
  });

  it('keeps room for nets whose shape nobody tells, until someone does', () => {
    expect(netsAfter(found(0), shown(1, [2]), found(1))).toEqual(['0: unknown', '1: 2']);
    expect(netsAfter(found(0), shown(0, [0, 1]))).toEqual(['0: 0 1']);
  });

  it('drops at the end of the search what was only tried, and has again what that had replaced', () => {
    const labels = (...all: number[]): JobEvent => {
      return { type: 'segmented', labels: Int32Array.from(all) };
    };
    const end: JobEvent = { type: 'stage', stage: 'compact', progress: 0.5 };
    const parts = [shown(0, [0, 1]), found(0), shown(1, [2]), found(1), shown(1, [3]), found(1)];
    // The whole body as one net, which comes to nothing better.
    const tried = [labels(0, 0, 1, 1), ...parts, shown(0, [0, 1, 2, 3]), found(0)];
    expect(netsAfter(...tried)).toEqual(['0: 0 1 2 3']);
    expect(netsAfter(...tried, end).sort()).toEqual(['0: 0 1', '1: 2', '1: 3']);
    // Or is taken: what is told then are other parts.
    expect(netsAfter(...tried, labels(0, 0, 0, 0), end)).toEqual(['0: 0 1 2 3']);
    // Pieces that become parts get the numbers of these; what nobody has told of stays.
    const pieces = [...parts, labels(0, 0, 1, 2, 3), found(3), end];
    expect(netsAfter(...pieces)).toEqual(['0: 0 1', '1: 2', '2: 3', '3: unknown']);
    const nets = new NetsSoFar();
    const changes = [...tried, end, end].map((event) => nets.follow(event));
    expect(changes.slice(-2)).toEqual([true, false]);
  });

  it('tells when there is something new to see', () => {
    const nets = new NetsSoFar();
    const events = [shown(0, [0]), found(0), shown(0, [0], [0]), shown(0, [0]), found(1)];
    expect(events.map((event) => nets.follow(event))).toEqual([false, true, false, true, true]);
  });
});

describe('a net on the mat', () => {
  /** A strip of two triangles, 1 by 4, that stands aslant. */
  const strip = (() => {
    const corners = [0, 0, 1, 0, 1, 4, 0, 0, 1, 4, 0, 4];
    const [sine, cosine] = [Math.sin(0.4), Math.cos(0.4)];
    return Float32Array.from(corners, (value, i) =>
      i % 2 === 0
        ? cosine * value - sine * corners[i + 1]!
        : sine * corners[i - 1]! + cosine * value,
    );
  })();

  it('lies on its long side and keeps its size', () => {
    const { corners, width, height } = flatNet({ ...picture([0, 1]), corners: strip });
    expect(width).toBeGreaterThan(height);
    // Within the steps in which it is turned.
    expect(width).toBeLessThan(4.2);
    expect(height).toBeLessThan(1.3);
    const [a, b] = [0, 2].map((at) => [corners[at]!, corners[at + 1]!] as const);
    expect(Math.hypot(a![0] - b![0], a![1] - b![1])).toBeCloseTo(1, 5);
    expect(Math.min(...corners)).toBeCloseTo(0, 5);
  });

  it('has its number on a face', () => {
    // Two triangles far apart: the middle of both lies on neither.
    const apart = Float32Array.of(0, 0, 3, 0, 0, 3, 10, 0, 13, 0, 10, 3);
    expect(namePlace(apart)).toEqual({ x: 1, y: 1 });
  });
});
