/** Where pieces lie on sheets and where else they could: what the studio says of a place, and what the engine does. */
import { describe, expect, it } from 'vitest';
import { placeOf, type PiecePlace } from '../../web/model/piece-shape.js';
import { SheetPieces } from '../../web/model/sheet-pieces.js';
import { snappedPlace } from '../../web/model/snapped-place.js';
import { addFlap } from './changed-result.js';
import { boxAndLidResult, cubeResult } from './fixtures.js';

/** The open box, 160 mm wide, and its lid, 40 mm wide, on one sheet; the lid at (150, 200). */
function boxAndLid() {
  const result = boxAndLidResult();
  const [box, lid] = result.pieces;
  result.pieces[0] = { ...box!, x: 10, y: 20 };
  result.pieces[1] = { ...lid!, sheet: 0, x: 150, y: 200 };
  return result;
}

/** How far the numbers of two lists are apart, at most. */
function farthest(list: readonly number[], other: readonly number[]): number {
  expect(list).toHaveLength(other.length);
  return Math.max(...list.map((value, i) => Math.abs(value - other[i]!)));
}

describe('places of pieces', () => {
  const pieces = new SheetPieces(boxAndLid(), 10);
  const lid = placeOf(pieces.result.pieces[1]!);

  it('are found by their points', () => {
    expect(pieces.at(0, [170, 220])).toBe(1);
    expect(pieces.at(0, [70, 80])).toBe(0);
    expect(pieces.at(0, [145, 220])).toBeNull();
    expect(pieces.at(1, [170, 220])).toBeNull();
  });

  it('are within the margins and beside the rulers', () => {
    expect(pieces.room(0)).toEqual({ left: 10, bottom: 10, right: 200, top: 287 });
    // Rulers need more than a small margin.
    expect(new SheetPieces(boxAndLid(), 2).room(0)).toMatchObject({ left: 7.5, right: 208 });
    // A sheet to come is like the others.
    expect(pieces.room(7)).toEqual(pieces.room(0));
    expect(pieces.faultAt(1, { ...lid, x: 160 })).toBeNull();
    expect(pieces.faultAt(1, { ...lid, x: 160.5 })).toEqual({ what: 'outside' });
    expect(pieces.faultAt(1, { ...lid, y: 9 })).toEqual({ what: 'outside' });
  });

  it('are not on other pieces, but may touch them', () => {
    // Of its box the strip of four squares takes the upper half, and the fifth square the lower left.
    const { x, y } = pieces.result.pieces[0]!;
    expect(pieces.sizeAt(0, placeOf(pieces.result.pieces[0]!))).toEqual([160, 80]);
    expect(pieces.faultAt(1, { ...lid, x: x + 40, y })).toBeNull();
    const fault = { what: 'overlap', piece: 0 };
    expect(pieces.faultAt(1, { ...lid, x: x + 39, y })).toEqual(fault);
    expect(pieces.faultAt(1, { ...lid, x: x + 40, y: y + 1 })).toEqual(fault);
    expect(pieces.faultAt(1, { ...lid, sheet: 1, x, y })).toBeNull();
    // Inside of it no outlines cross.
    const small = boxAndLid();
    small.pieces[1] = {
      ...small.pieces[1]!,
      vertices: small.pieces[1]!.vertices.map((v) => v / 4),
    };
    const within = new SheetPieces(small, 10);
    expect(within.faultAt(1, { ...lid, x: x + 75, y: y + 55 })).not.toBeNull();
  });

  it('take flaps into account', () => {
    const result = cubeResult();
    const [width] = new SheetPieces(result, 10).sizeAt(0, placeOf(result.pieces[0]!));
    for (const seam of result.seams.keys()) addFlap(result, seam, 5);
    const pieces = new SheetPieces(result, 10);
    const [flapped] = pieces.sizeAt(0, placeOf(result.pieces[0]!));
    expect(flapped).toBeGreaterThan(width + 4);
  });
});

describe('moving a piece', () => {
  const pieces = new SheetPieces(boxAndLid(), 10);
  const shape = pieces.shape(0);
  const before = placeOf(pieces.result.pieces[0]!);

  it('turns it about its middle, and back', () => {
    const middle = (place: PiecePlace) => {
      const { box } = shape.at(place);
      return [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
    };
    let place = before;
    for (let i = 0; i < 24; ++i) {
      place = shape.turnedBy(place, 15);
      expect(place.turn).toBeGreaterThan(-180);
      expect(place.turn).toBeLessThanOrEqual(180);
      expect(farthest(middle(place), middle(before))).toBeLessThan(1e-6);
    }
    expect([place.x, place.y, place.turn]).toEqual([
      expect.closeTo(before.x, 6),
      expect.closeTo(before.y, 6),
      before.turn,
    ]);
  });

  it('tells the motion that leads there', () => {
    const place = { ...shape.turnedBy(before, 30), x: 40, y: 60 };
    const { about, degrees, by } = shape.motionTo(place);
    const angle = (degrees * Math.PI) / 180;
    const moved = shape.at(before).polygons.map((polygon) =>
      polygon.map(([x, y]) => {
        const [u, v] = [x - about[0], y - about[1]];
        return [
          about[0] + Math.cos(angle) * u - Math.sin(angle) * v + by[0],
          about[1] + Math.sin(angle) * u + Math.cos(angle) * v + by[1],
        ];
      }),
    );
    expect(farthest(moved.flat(2), shape.at(place).polygons.flat(2))).toBeLessThan(1e-9);
  });

  it('finds the nearest place with room, or none', () => {
    const lid = placeOf(pieces.result.pieces[1]!);
    expect(pieces.freePlace(1, lid)).toEqual(lid);
    const wanted = { ...lid, x: before.x + 60, y: before.y + 50 };
    const found = pieces.freePlace(1, wanted)!;
    expect(pieces.faultAt(1, found)).toBeNull();
    expect(Math.hypot(found.x - wanted.x, found.y - wanted.y)).toBeLessThan(55);
    expect(pieces.freePlace(1, { ...lid, x: 500 })).toMatchObject({ x: 160, y: 200 });
    const large = { ...pieces.result, sheets: [{ width: 100, height: 100 }] };
    expect(new SheetPieces(large, 10).freePlace(0, before)).toBeNull();
  });

  it('snaps to the edges of what can be printed on, and to whole millimetres', () => {
    const room = pieces.room(0);
    const at = (x: number, y: number) => ({ sheet: 0, x, y, turn: 0 });
    expect(snappedPlace(at(11.4, 100.4), [40, 40], room, 2)).toEqual(at(10, 100));
    expect(snappedPlace(at(161.3, 245.8), [40, 40], room, 2)).toEqual(at(160, 247));
    expect(snappedPlace(at(12.6, 12.6), [40, 40], room, 2)).toEqual(at(13, 13));
  });
});
