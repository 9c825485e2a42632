import { describe, expect, it } from 'vitest';
import { doPanelsFit } from '../../web/model/flat-panels.js';
import { boxAndLidResult, cubeResult, tetrahedronResult } from './fixtures.js';

describe('flat panels', () => {
  it('are squares of two triangles for a cube', () => {
    const { pieces } = cubeResult();
    expect(doPanelsFit(pieces, 40, 40)).toBe(true);
    expect(doPanelsFit(pieces, 39.9, 60)).toBe(false);
  });

  it('may lie at any angle', () => {
    const [, lid] = boxAndLidResult().pieces;
    const root = Math.SQRT1_2;
    const vertices = lid!.vertices.map((_, i, all) =>
      i % 2 === 0 ? root * (all[i]! - all[i + 1]!) : root * (all[i - 1]! + all[i]!),
    );
    expect(doPanelsFit([{ ...lid!, vertices }], 40, 40)).toBe(true);
  });

  it('are triangles where all edges are folded', () => {
    // 40 mm wide, and as high as the root of three by two.
    const { pieces } = tetrahedronResult();
    expect(doPanelsFit(pieces, 34.7, 40.1)).toBe(true);
    expect(doPanelsFit(pieces, 40.1, 34.7)).toBe(true);
    expect(doPanelsFit(pieces, 34.5, 40.1)).toBe(false);
  });
});
