import { describe, expect, it } from 'vitest';
import { SamePlaces } from '../../web/model/same-places.js';
import { numbers } from './damage.js';

describe('SamePlaces', () => {
  it('gives points that lie together one number, wherever the walls of its grid are', () => {
    const places = new SamePlaces(1);
    const below = numbers(7);
    const coordinate = (): number => 10 * (below(100) - 50);
    const points = Array.from({ length: 300 }, () => [coordinate(), coordinate(), coordinate()]);
    const known = new Map<string, number>();
    for (const point of points) {
      const number = places.of(point, 0);
      const key = point.join(' ');
      expect(known.get(key) ?? number).toBe(number);
      known.set(key, number);
    }
    expect(new Set(known.values()).size).toBe(known.size);
    for (const point of points) {
      const moved = point.map((value) => value + (below(199) - 99) / 100);
      expect(places.of(moved, 0)).toBe(known.get(point.join(' ')));
    }
  });

  it('tells points apart that lie farther from each other', () => {
    const places = new SamePlaces(0.5);
    const points = [0, 0, 0, 0.6, 0, 0, 0, -0.6, 0, 0, 0, 0.4];
    expect([0, 1, 2, 3].map((index) => places.of(points, index))).toEqual([0, 1, 2, 0]);
  });
});
