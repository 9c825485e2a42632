import { describe, expect, it } from 'vitest';
import { doubts, folded, joiningLetters } from '../../web/app/folding-words.js';
import { stepMarks } from '../../web/app/step-marks.js';
import { stepWords } from '../../web/app/step-words.js';
import { modelMarks } from '../../web/app/model-marks.js';
import { stepTimes } from '../../web/model/choreography.js';
import { assemblySteps } from '../../web/model/assembly-steps.js';
import type { JobResult, Piece } from '../../web/model/job.js';
import { secondOf, tempoFor, timeAt } from '../../web/model/tempo.js';
import { english } from '../../web/words/en/index.js';
import { beakResult, boxAndLidResult, cubeResult } from './fixtures.js';

describe('the words of a folding', () => {
  it('tell what there is to see', () => {
    const letters = ['B', 'A', 'C'];
    const words = [0, 0.001, 0.35, 0.699, 0.7, 0.75, 0.9, 1].map((time) =>
      folded(english, time, letters),
    );
    expect(words).toEqual([
      'flat',
      'folded by 5 %',
      'folded by 50 %',
      'folded by 95 %',
      'folded',
      'joining piece B',
      'joining piece A',
      'the model',
    ]);
    expect(folded(english, 0.9, ['A'])).toBe('folded');
    expect(stepTimes(3).map((time) => folded(english, time, letters))).toEqual([
      'flat',
      'folded',
      'piece B is in place',
      'piece A is in place',
      'the model',
    ]);
    expect(stepTimes(1).map((time) => folded(english, time, ['A']))).toEqual([
      'flat',
      'folded',
      'the model',
    ]);
  });

  it('follow the order of joining', () => {
    expect(joiningLetters(boxAndLidResult().pieces)).toEqual(['A', 'B']);
  });

  it('warn of pieces without a motion', () => {
    const { pieces } = boxAndLidResult();
    const without = ({ motion: _, ...piece }: Piece): Piece => piece;
    expect(doubts(english, pieces)).toBe('');
    expect(doubts(english, [pieces[0]!, without(pieces[1]!)])).toMatch(
      /^No way to fold B is known/,
    );
    expect(doubts(english, pieces.map(without))).toMatch(/^No way to fold these pieces is known/);
  });

  it('list names as people do', () => {
    expect([['A'], ['A', 'B'], ['A', 'B', 'C']].map(english.speech.all)).toEqual([
      'A',
      'A and B',
      'A, B and C',
    ]);
  });
});

describe('the words of a step', () => {
  const wordsOf = (result: JobResult) =>
    assemblySteps(result.pieces).map((step) => stepWords(english, step, result));

  it('say how a piece is creased, closed and glued', () => {
    const [box, lid] = wordsOf(boxAndLidResult());
    expect(box).toBe('crease its 4 folds as mountains. Close its seam.');
    expect(lid).toBe('it has no folds. Glue it to A along 4 edges.');
  });

  it('count edges as they are numbered on the sheets', () => {
    const result = boxAndLidResult();
    const between = result.seams.filter(({ pieces: [one, other] }) => one !== other);
    // Two of the four edges lie in a straight line, and have one number.
    const [first, second, ...others] = between;
    const modelEdges = Int32Array.of(...first!.modelEdges, ...second!.modelEdges).sort();
    const seams = [{ ...first!, modelEdges }, ...others];
    expect(wordsOf({ ...result, seams })[1]).toContain('Glue it to A along 3 edges.');
  });

  it('name the few folds that differ', () => {
    expect(wordsOf(beakResult())[0]).toMatch(/^crease its 3 folds as \w+s, then turn this one/);
  });
});

describe('stepMarks', () => {
  it('lie where the edges lie on the sheets', () => {
    const { pieces } = boxAndLidResult();
    const [, lid] = assemblySteps(pieces);
    const marks = stepMarks(lid!, pieces);
    expect([...marks.keys()].sort()).toEqual([0, 1]);
    for (const { kind, from, to } of [...marks.values()].flat()) {
      expect(kind).toBe('border');
      expect(Math.hypot(to[0] - from[0], to[1] - from[1])).toBeCloseTo(40, 9);
      expect(Math.min(...from, ...to)).toBeGreaterThanOrEqual(10);
    }
  });

  it('number each seam at both of its sides', () => {
    const { pieces } = cubeResult();
    const [step] = assemblySteps(pieces);
    const labels = [...stepMarks(step!, pieces).values()]
      .flat()
      .flatMap(({ label }) => label ?? []);
    const numbers = step!.seams.flatMap((_, i) => [String(i + 1), String(i + 1)]);
    expect(labels.sort()).toEqual(numbers.sort());
  });
});

describe('modelMarks', () => {
  it('lie on edges of the model that both sides of a border have', () => {
    const result = boxAndLidResult();
    const [box, lid] = assemblySteps(result.pieces);
    const { edges, kinds } = modelMarks(lid!, result);
    expect(kinds).toEqual(['border', 'border', 'border', 'border']);
    // The rim of the box: four vertices, each at two of the edges.
    const ends = new Map<number, number>();
    for (const vertex of edges) ends.set(vertex, (ends.get(vertex) ?? 0) + 1);
    expect([...ends.values()]).toEqual([2, 2, 2, 2]);
    // All of them lie in one side of the cube.
    const flat = [0, 1, 2].filter((axis) => {
      const places = [...ends.keys()].map((vertex) => result.model.vertices[3 * vertex + axis]);
      return new Set(places).size === 1;
    });
    expect(flat).toHaveLength(1);
    const seams = modelMarks(box!, result);
    expect(seams.kinds.every((kind) => kind === 'seam')).toBe(true);
    expect(seams.edges.length).toBe(2 * box!.seams.flat().length);
  });
});

describe('the tempo', () => {
  it('goes there and back', () => {
    const tempo = tempoFor(8);
    for (const time of [0, 0.3, 0.7, 0.71, 1]) {
      expect(timeAt(tempo, secondOf(tempo, time))).toBeCloseTo(time, 12);
    }
    expect(secondOf(tempo, 1)).toBe(tempo.fold + tempo.join);
    expect(timeAt(tempo, 1000)).toBe(1);
  });

  it('does not tire with many pieces', () => {
    expect(tempoFor(200).join).toBeLessThan(15);
  });
});
