/** An end is told only when it can be known, and never moves away. */
import { describe, expect, it } from 'vitest';
import { timeWords } from '../../web/app/progress-words.js';
import { unknownEnd, withReading, type Reading } from '../../web/model/time-left.js';
import { english } from '../../web/words/en/index.js';

/** What is told of the time left at every reading; null where nothing is. */
function told(readings: Reading[]): (number | null)[] {
  let guess = unknownEnd;
  return readings.map((reading) => {
    guess = withReading(guess, reading);
    return guess.end === null ? null : guess.end - reading.second;
  });
}

/** Readings five times a second of a run that is so far at a second. */
const run = (seconds: number, progressAt: (second: number) => number): Reading[] =>
  Array.from({ length: 5 * seconds }, (_, i) => ({
    second: i / 5,
    progress: Math.min(1, progressAt(i / 5)),
  }));

/** Times that follow each other never grow. */
function expectToFall(times: (number | null)[]): void {
  times.forEach((time, i) => {
    const before = times[i - 1];
    if (time !== null && typeof before === 'number') expect(time).toBeLessThanOrEqual(before);
  });
}

describe('the time left', () => {
  it('is told of a run at an even pace, after a while, and is right', () => {
    const readings = run(60, (second) => second / 60);
    const times = told(readings);
    expect(times.slice(0, 5 * 9).every((time) => time === null)).toBe(true);
    times.forEach((time, i) => {
      if (i > 5 * 12) expect(time).toBeCloseTo(60 - readings[i]!.second, 6);
    });
    expectToFall(times);
  });

  it('is not told of a run whose pace is not that of the whole', () => {
    const times = told(
      run(30, (second) => (second < 10 ? second / 20 : 0.5 + (second - 10) / 400)),
    );
    expect(times.slice(5 * 13).filter((time) => time !== null)).toEqual([]);
  });

  it('is taken back when the run stands still', () => {
    const times = told(run(60, (second) => Math.min(second, 25) / 60));
    expect(times[5 * 24]).toBeCloseTo(36, 0);
    expect(times.slice(5 * 45).every((time) => time === null)).toBe(true);
    expectToFall(times);
  });

  it('never grows while it is told, at any pace', () => {
    // A generator of its own: the same numbers every time.
    let state = 7;
    const random = (): number => (state = (state * 16807) % 2147483647) / 2147483647;
    for (let trial = 0; trial < 50; ++trial) {
      let [progress, pace] = [0, 0.01];
      const readings = run(90, () => {
        if (random() < 0.02) pace = 0.03 * random() ** 2;
        return (progress += pace / 5);
      });
      const times = told(readings);
      expectToFall(times);
      for (const time of times) if (time !== null) expect(time).toBeGreaterThanOrEqual(0);
    }
  });

  it('has words without false precision', () => {
    const words = [null, 3, 5, 12, 90, 91, 600].map((seconds) => timeWords(english, seconds));
    expect(words).toEqual([
      '',
      '',
      'about 5 seconds left',
      'about 15 seconds left',
      'about 90 seconds left',
      'about 2 minutes left',
      'about 10 minutes left',
    ]);
  });
});
