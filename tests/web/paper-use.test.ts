import { describe, expect, it } from 'vitest';
import { paperUse, sheetFills } from '../../web/model/paper-use.js';
import { addFlap } from './changed-result.js';
import { boxAndLidResult } from './fixtures.js';

/** A4 within margins of 10 mm. */
const printable = 190 * 277;

describe('the use of paper', () => {
  it('is paper inside cut lines over printable area', () => {
    const fills = sheetFills(boxAndLidResult(), 10);
    expect(fills[0]).toBeCloseTo((5 * 1600) / printable, 12);
    expect(fills[1]).toBeCloseTo(1600 / printable, 12);
    expect(paperUse(boxAndLidResult(), 10)).toBeCloseTo((3 * 1600) / printable, 12);
  });

  it('counts flaps and loose strips', () => {
    const result = boxAndLidResult();
    const [box] = sheetFills(result, 0);
    const between = result.seams.findIndex(({ pieces: [a, b] }) => a !== b);
    addFlap(result, between, 5);
    const outline = Float64Array.of(0, 0, 30, 0, 30, 10, 0, 10);
    const label = { text: '1', x: 0, y: 0, angle: 0, size: 2 };
    result.strips = [
      { id: 'A:1', modelEdge: 0, sheet: 1, outline, fold: Float64Array.of(), foldAngle: 90, label },
    ];
    const [flapped, stripped] = sheetFills(result, 0);
    expect((flapped! - box!) * 210 * 297).toBeCloseTo(200, 6);
    expect(stripped! * 210 * 297).toBeCloseTo(1600 + 300, 6);
  });
});
