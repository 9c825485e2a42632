import { describe, expect, it } from 'vitest';
import { equalPieces } from '../../web/model/equal-pieces.js';
import type { JobResult, Piece } from '../../web/model/job.js';
import { boxAndLidResult, cubeResult } from './fixtures.js';

/** A result of one piece and of copies that are changed each in its way. */
function withCopies(result: JobResult, ...changes: ((piece: Piece) => Piece)[]): JobResult {
  const [piece] = result.pieces;
  const copies = changes.map((change, i) => ({ ...change(piece!), name: `copy ${i + 1}` }));
  return { ...result, pieces: [{ ...piece!, name: 'first' }, ...copies] };
}

/** Turned by so many degrees, or mirrored: x and y change places then. */
function moved(piece: Piece, degrees: number, mirrored = false): Piece {
  const angle = (degrees * Math.PI) / 180;
  const vertices = Float64Array.from(piece.vertices, (_, i) => {
    const x = piece.vertices[i - (i % 2) + (mirrored ? 1 : 0)]!;
    const y = piece.vertices[i - (i % 2) + (mirrored ? 0 : 1)]!;
    return i % 2 === 0
      ? x * Math.cos(angle) - y * Math.sin(angle)
      : x * Math.sin(angle) + y * Math.cos(angle);
  });
  const outlines = piece.outlines.map((outline) =>
    mirrored ? outline.slice().reverse() : outline,
  );
  return { ...piece, vertices, outlines };
}

/** Its outlines begin at another corner. */
function begunElsewhere(piece: Piece): Piece {
  const outlines = piece.outlines.map((outline) =>
    Int32Array.of(...outline.subarray(1), outline[0]!),
  );
  return { ...piece, outlines };
}

/** One corner of the outline is moved by so many mm. */
function bent(piece: Piece, by: number): Piece {
  const vertices = piece.vertices.slice();
  vertices[2 * piece.outlines[0]![0]!]! += by;
  return { ...piece, vertices };
}

describe('equal pieces', () => {
  it('are found however they are turned and wherever their outlines begin', () => {
    const result = withCopies(
      cubeResult(),
      (piece) => moved(piece, 37),
      (piece) => begunElsewhere(moved(piece, 180)),
    );
    expect(equalPieces(result)).toEqual([['first', 'copy 1', 'copy 2']]);
  });

  it('are not those of other lengths, angles or folds', () => {
    const result = withCopies(
      cubeResult(),
      (piece) => bent(piece, 0.4),
      (piece) => ({ ...piece, foldAngles: piece.foldAngles.map((angle) => angle + 2) }),
    );
    expect(equalPieces(result)).toEqual([]);
  });

  it('are not mirror images, unless these are symmetric', () => {
    const skew = withCopies(cubeResult(), (piece) => bent(piece, 7)).pieces[1]!;
    const result = withCopies({ ...cubeResult(), pieces: [skew] }, (piece) =>
      moved(piece, 0, true),
    );
    expect(equalPieces(result)).toEqual([]);
  });

  it('are none of different models', () => {
    expect(equalPieces(boxAndLidResult())).toEqual([]);
  });
});
