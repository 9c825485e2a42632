import { describe, expect, it } from 'vitest';
import { building } from '../../web/words/en/building.js';

describe('times', () => {
  it.each([
    [0, 'about 5 minutes'],
    [686, 'about 10 minutes'],
    [55 * 60, 'about 55 minutes'],
    [58 * 60, 'about 1 hour'],
    [90 * 60, 'about 1½ hours'],
    [3 * 3600 + 700, 'about 3 hours'],
    [9.4 * 3600, 'about 9½ hours'],
    [21.3 * 3600, 'about 21 hours'],
  ])('are rounded as people say them: %d s', (seconds, words) => {
    expect(building.duration({ seconds })).toBe(words);
  });
});

describe('lists of edges', () => {
  const list = { runs: ['5–7', '9'], first: '5', last: '9', edges: 4, unnumbered: 0 };

  it('say where to start and what comes last', () => {
    expect(building.close(list)).toBe('Close it along 5–7, 9. Start at 5; 9 comes last.');
  });

  it('say what has no number', () => {
    expect(building.close({ ...list, edges: 5, unnumbered: 1, last: null })).toBe(
      'Close it along 5–7, 9 and 1 edge without a number. Start at 5.',
    );
    const bare = { runs: [], first: null, last: null, edges: 3, unnumbered: 3 };
    expect(building.close(bare)).toBe('Close it along 3 edges without a number.');
    expect(building.glue({ ...bare, groups: [{ name: 'A', runs: [] }] })).toBe(
      'Glue it to A along 3 edges without a number.',
    );
  });

  it('name the pieces that are met', () => {
    const groups = [
      { name: 'A', runs: ['5–7'] },
      { name: 'C', runs: ['9'] },
    ];
    expect(building.glue({ ...list, groups })).toBe(
      'Glue it to A along 5–7, then to C along 9. Start at 5; 9 comes last.',
    );
  });

  it('need no start with a single edge', () => {
    const one = { runs: ['5'], first: '5', last: '5', edges: 1, unnumbered: 0 };
    expect(building.close(one)).toBe('Close it along 5.');
  });
});

describe('folds', () => {
  it('are told by the few', () => {
    const fold = (folds: number, turn: number) =>
      building.fold({ folds, crease: 'mountain', turn });
    expect(fold(0, 0)).toBe('It has no folds.');
    expect(fold(1, 0)).toBe('Crease its one fold as a mountain.');
    expect(fold(5, 0)).toBe('Crease all its 5 folds as mountains.');
    expect(fold(5, 1)).toBe('Crease its 5 folds: one is a valley, all others are mountains.');
    expect(fold(9, 2)).toBe('Crease its 9 folds: 2 are valleys, all others are mountains.');
  });

  it('are all mountains where no piece has another one', () => {
    expect(building.valleyPieces({ names: [], pieces: 0, all: false })).toBe(
      'All folds are mountains.',
    );
    expect(building.valleyPieces({ names: ['A', 'C'], pieces: 2, all: false })).toBe(
      'Valley folds are only on A and C: the steps show them in blue.',
    );
  });
});
