import { describe, expect, it } from 'vitest';
import type { JobResult } from '../../web/model/job.js';
import { printAdvice } from '../../web/model/print-advice.js';
import { englishPhrase } from '../../web/words/phrase.js';
import { scaled } from './changed-result.js';
import { boxAndLidResult, cubeResult, tetrahedronResult } from './fixtures.js';

function adviceOn(result: JobResult, margin = 10): string[] {
  return printAdvice(result, margin).map(englishPhrase);
}

/** All pieces on the first sheet. */
function onOneSheet(result: JobResult): JobResult {
  const pieces = result.pieces.map((piece) => ({ ...piece, sheet: 0 }));
  return { ...result, pieces, sheets: result.sheets.slice(0, 1) };
}

/** The tetrahedron with edges of so many mm, said to have so many faces. */
function solid(edge: number, faces: number): JobResult {
  const result = scaled(tetrahedronResult(), edge / 40);
  return { ...result, model: { ...result.model, faces: new Int32Array(3 * faces) } };
}

describe('advice before printing', () => {
  it('is not given on a good result', () => {
    expect(adviceOn(cubeResult())).toEqual([]);
    expect(adviceOn(onOneSheet(boxAndLidResult()))).toEqual([]);
  });

  it('proposes a size and fewer faces where seams are too short', () => {
    // High: 5√3 mm; 800 faces share a surface on which edges shall be 1.2 times as long, and a bit.
    expect(adviceOn(solid(10, 800))).toEqual([
      'half of the seams are at most 10 mm long, which is hard to glue; easier to build: ' +
        '20 mm high (--height 20), or simplified to 470 faces (--faces 470)',
    ]);
  });

  it('begins below 12 mm', () => {
    expect(adviceOn(scaled(cubeResult(), 0.3 + 1e-9))).toEqual([]);
    expect(adviceOn(scaled(cubeResult(), 0.29))).toEqual([
      'half of the seams are at most 11.6 mm long, which is hard to glue; easier to build: 20 mm high (--height 20)',
    ]);
  });

  it('goes by the middle of all seams', () => {
    const result = cubeResult();
    const short = scaled(cubeResult(), 0.2).pieces[0]!;
    // Four of seven seams as short as 8 mm, and then three.
    const seamsOf = (piece: number): JobResult['seams'] =>
      result.seams.map((seam) => ({
        ...seam,
        pieces: [piece, piece],
        modelEdges: seam.modelEdges.map((edge) => edge + 100 * piece),
      }));
    const other = { ...short, modelEdges: short.modelEdges.map((edge) => edge + 100) };
    const mixed = { ...result, pieces: [result.pieces[0]!, other] };
    const [long, brief] = [seamsOf(0), seamsOf(1)];
    const codes = (seams: JobResult['seams']): string[] =>
      printAdvice({ ...mixed, seams }, 10).map(({ code }) => code);
    expect(codes([...long.slice(0, 3), ...brief.slice(0, 4)])).toContain('short-seams');
    expect(codes([...long.slice(0, 4), ...brief.slice(0, 3)])).not.toContain('short-seams');
  });

  it('proposes no shape that is lost, and no paper that nobody has', () => {
    const words = (edge: number, faces: number): string => adviceOn(solid(edge, faces))[0]!;
    expect(words(10, 339)).toContain('--faces 200)');
    expect(words(10, 338)).not.toContain('--faces');
    // At 20 mm it is 2.3 times as high, and takes 5.3 times as many sheets.
    const onSheets = (count: number): string => {
      const result = solid(10, 4);
      const sheets = Array.from({ length: count }, () => result.sheets[0]!);
      return adviceOn({ ...result, sheets })[0]!;
    };
    expect(onSheets(3)).toContain('--height 20)');
    expect(onSheets(4)).toBe('half of the seams are at most 10 mm long, which is hard to glue');
  });

  it('proposes no size at which a flat side is larger than a sheet', () => {
    const slim = scaled(cubeResult(), 0.25);
    const stretched = (mm: number): string => {
      const [piece] = slim.pieces;
      const vertices = piece!.vertices.map((value, i) => (i % 2 === 0 ? value : (value * mm) / 10));
      // Only what is flat counts: seams stay as they are said to be.
      const modelEdges = piece!.modelEdges.map((edge) => edge + 100);
      const sides = { ...piece!, vertices, modelEdges };
      return adviceOn({ ...slim, pieces: [piece!, sides] })[0]!;
    };
    expect(stretched(10)).toContain('--height 20');
    expect(stretched(150)).toContain('--height 20');
    expect(stretched(160)).not.toContain('--height');
  });

  it('proposes no fewer faces where these are shares of flat panels', () => {
    const result = scaled(cubeResult(), 0.25);
    const many = { ...result.model, faces: new Int32Array(3 * 800) };
    expect(adviceOn({ ...result, model: many })[0]).not.toContain('--faces');
  });

  it('tells the size of what lies flat by its longest side', () => {
    const result = scaled(cubeResult(), 0.25);
    const flat = result.model.vertices.map((value, i) => (i % 3 === 1 ? value / 5 : value * 2));
    expect(adviceOn({ ...result, model: { ...result.model, vertices: flat } })[0]).toContain(
      '30 mm wide (--width 30)',
    );
  });

  it('tells of a last sheet that is almost empty', () => {
    expect(adviceOn(boxAndLidResult())).toEqual([
      'the last sheet, number 2, is almost empty: 3 % of it is used, by piece B',
    ]);
    // With a margin of 70.7 mm the lid takes 15 % of what is left.
    expect(adviceOn(boxAndLidResult(), 70.8)).toEqual([]);
    expect(adviceOn(boxAndLidResult(), 70.6)).toHaveLength(1);
  });

  it('names pieces that are easily lost', () => {
    const [small, large] = [
      { width: 9.9, height: 9.9 },
      { width: 9.9, height: 10 },
    ];
    const result = onOneSheet(boxAndLidResult());
    const sized = (...sizes: { width: number; height: number }[]): JobResult => {
      const pieces = result.pieces.map((piece, i) => ({ ...piece, ...sizes[i] }));
      return { ...result, pieces };
    };
    expect(adviceOn(sized(large, large))).toEqual([]);
    expect(adviceOn(sized(large, small))).toEqual([
      'piece B is smaller than 10 mm and easily lost: cut it out last',
    ]);
    expect(adviceOn(sized(small, small))).toEqual([
      'pieces A, B are smaller than 10 mm and easily lost: cut them out last',
    ]);
  });
});
