import { expect, test } from 'vitest';
import { rulerStep, rulerTicks } from '../../web/view/ruler.js';

test('numbers never touch, however large the sheets are seen', () => {
  for (let scale = 0.05; scale < 40; scale *= 1.3) {
    const { main, parts } = rulerStep(scale);
    if (main < 500) expect(main * scale).toBeGreaterThanOrEqual(34);
    expect(parts === 1 || (main * scale) / parts >= 4).toBe(true);
  }
});

test('a ruler at true size has a number for every 10 mm, and its lines lie at their mm', () => {
  const scale = 96 / 25.4;
  const ticks = rulerTicks(50, scale, 400);
  const main = ticks.filter(({ isMain }) => isMain);
  expect(main.map(({ at }) => at)).toEqual([-10, 0, 10, 20, 30, 40, 50, 60, 70, 80, 90]);
  for (const { at, pixel } of ticks) {
    expect(pixel).toBeCloseTo(50 + at * scale);
    expect(pixel).toBeGreaterThanOrEqual(0);
    expect(pixel).toBeLessThanOrEqual(400);
  }
});

test('a zero far outside leaves whole numbers', () => {
  const ticks = rulerTicks(-12_345, 2, 100);
  expect(ticks.length).toBeGreaterThan(10);
  for (const { at } of ticks) expect(at * 2).toBe(Math.round(at * 2));
});
