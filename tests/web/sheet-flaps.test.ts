import { describe, expect, it } from 'vitest';
import { pieceFlapEdits } from '../../web/model/piece-flaps.js';
import { SheetEdges } from '../../web/model/sheet-edges.js';
import {
  flapAt,
  gripOf,
  pulledHeight,
  withHeight,
  type SheetFlap,
} from '../../web/model/sheet-flaps.js';
import { addFlap } from './changed-result.js';
import { boxAndLidResult } from './fixtures.js';

/** With a flap of 6 mm at the seam between box and lid, and the edges at both of its sides. */
function flapped() {
  const result = boxAndLidResult();
  const seam = result.seams.findIndex(({ pieces: [one, other] }) => one !== other);
  addFlap(result, seam, 6);
  const edges = new SheetEdges(result);
  const here = edges.all.find((edge) => edge.seam === result.seams[seam] && edges.hasFlap(edge))!;
  return { edges, here, there: edges.partnerOf(here)! };
}

/** On a base of 10 mm, upwards, with sides of 45 degrees. */
const trapezium: SheetFlap = {
  sheet: 0,
  corners: [
    [10, 0],
    [7, 3],
    [3, 3],
    [0, 0],
  ],
  height: 3,
};

describe('flaps on sheets', () => {
  it('are found from both sides of their seam', () => {
    const { edges, here, there } = flapped();
    const flap = flapAt(edges, here)!;
    expect(flap.height).toBeCloseTo(6);
    expect(flap.sheet).toBe(here.sheet);
    expect(flap.corners[0]).toEqual(here.from);
    expect(flap.corners[3]).toEqual(here.to);
    expect(flapAt(edges, there)).toEqual(flap);
  });

  it('are not where there are none', () => {
    const edges = new SheetEdges(boxAndLidResult());
    for (const edge of edges.all) expect(flapAt(edges, edge)).toBeNull();
  });

  it('are taken at the middle of their top and pulled in steps of half a millimetre', () => {
    expect(gripOf(trapezium)).toEqual([5, 3]);
    expect(pulledHeight(trapezium, [4, 7.3])).toBe(7.5);
    expect(pulledHeight(trapezium, [40, 7.2])).toBe(7);
  });

  it('are never higher or lower than flaps may be', () => {
    expect(pulledHeight(trapezium, [5, -3])).toBe(1);
    expect(pulledHeight(trapezium, [5, 90])).toBe(50);
  });

  it('keep the directions of their sides until these meet', () => {
    expect(withHeight(trapezium, 4)).toEqual([
      [10, 0],
      [6, 4],
      [4, 4],
      [0, 0],
    ]);
    expect(withHeight(trapezium, 8)).toEqual([
      [10, 0],
      [5, 8],
      [5, 8],
      [0, 0],
    ]);
  });
});

describe('all flaps of a piece', () => {
  const { edges } = flapped();
  const piece = 0;
  const seams = edges.result.seams.filter(({ pieces }) => pieces.includes(piece));
  const between = seams.filter(({ pieces: [one, other] }) => one !== other);

  it('go to the piece or to the others, but for those within it', () => {
    const here = pieceFlapEdits(edges, piece, 'here');
    expect(here).toHaveLength(between.length);
    for (const edit of here) expect(edit).toMatchObject({ kind: 'flap', side: 'first' });
    const there = pieceFlapEdits(edges, piece, 'there');
    expect(there.map((edit) => ({ ...edit, side: 'first' }))).toEqual(here);
  });

  it('are taken away, or left to the program again, at every seam', () => {
    expect(pieceFlapEdits(edges, piece, 'none')).toHaveLength(seams.length);
    for (const edit of pieceFlapEdits(edges, piece, 'usual')) {
      expect(edit).toMatchObject({ kind: 'flap', side: 'auto' });
    }
  });
});
