/** Edits of every kind that are taken over to the result of a corrected model, or have no place there. */
import { describe, expect, it } from 'vitest';
import type { DocumentEdit } from '../../web/model/document-edits.js';
import type { JobResult } from '../../web/model/job.js';
import { ModelMatch } from '../../web/model/model-match.js';
import { movedEdit } from '../../web/model/moved-edit.js';
import { boxAndLidResult } from './fixtures.js';

const before = boxAndLidResult();

/** The same result with its parts, pieces, faces and vertices in the opposite order. */
function turnedRound(result: JobResult): JobResult {
  const { model, labels, pieces, parts } = result;
  const vertices = Float64Array.from(model.vertices);
  const lastVertex = vertices.length / 3 - 1;
  const lastFace = labels.length - 1;
  for (let i = 0; i <= lastVertex; ++i) {
    vertices.set(model.vertices.subarray(3 * i, 3 * i + 3), 3 * (lastVertex - i));
  }
  const faces = Int32Array.from(model.faces);
  labels.forEach((_, face) => {
    const corners = [...model.faces.subarray(3 * face, 3 * face + 3)];
    faces.set(
      corners.map((corner) => lastVertex - corner),
      3 * (lastFace - face),
    );
  });
  return {
    ...result,
    model: { ...model, vertices, faces },
    labels: Int32Array.from(labels, (_, face) => parts - 1 - labels[lastFace - face]!),
    pieces: [...pieces].reverse().map((piece) => ({
      ...piece,
      part: parts - 1 - piece.part,
      sources: piece.sources.map((face) => lastFace - face),
    })),
  };
}

const after = turnedRound(before);
const match = new ModelMatch(before, after);
const lastVertex = before.model.vertices.length / 3 - 1;
const lastFace = before.labels.length - 1;
const [v, w, u] = before.model.faces as unknown as [number, number, number];

describe('movedEdit', () => {
  const turned = (...vertices: number[]): number[] => vertices.map((vertex) => lastVertex - vertex);

  it.each<[DocumentEdit, object]>([
    [{ kind: 'cut', edge: [v, w] }, { edge: turned(v, w) }],
    [
      { kind: 'lock', edge: [w, v], as: 'fold' },
      { edge: turned(w, v), as: 'fold' },
    ],
    [
      { kind: 'flap', edge: [w, v], side: 'first', height_mm: 3 },
      { edge: turned(w, v), side: 'first', height_mm: 3 },
    ],
    [
      { kind: 'join', edge: [v, w], open: [w, u], search: true },
      { edge: turned(v, w), open: turned(w, u), search: true },
    ],
    [
      { kind: 'assign', faces: [0, 1], part: 1 },
      { faces: [lastFace - 1, lastFace], part: 2 },
    ],
    [
      { kind: 'split', part: 2, into: 3 },
      { part: 1, into: 3 },
    ],
    [
      { kind: 'again', part: 1, seed: 9 },
      { part: 2, seed: 9 },
    ],
    [{ kind: 'merge', parts: [1, 2] }, { parts: [2, 1] }],
    [
      { kind: 'name', part: 1, text: 'Box' },
      { part: 2, text: 'Box' },
    ],
    [
      { kind: 'place', piece: 1, sheet: 1, x_mm: 20, y_mm: 30, turn_deg: 90 },
      { piece: 2, sheet: 1, x_mm: 20, y_mm: 30, turn_deg: 90 },
    ],
    [{ kind: 'unpin', piece: 2 }, { piece: 1 }],
    [{ kind: 'paper', options: { paper: 'A3' } }, { options: { paper: 'A3' } }],
    [{ kind: 'print', options: { style: 'blender' } }, { options: { style: 'blender' } }],
  ])('takes over %o', (edit, moved) => {
    expect(movedEdit(edit, match, before, after)).toEqual({ kind: edit.kind, ...moved });
  });

  it.each<[DocumentEdit, string]>([
    [{ kind: 'cut', edge: [v, 999] }, 'edge'],
    [{ kind: 'join', edge: [v, w], open: [v, 999] }, 'edge'],
    [{ kind: 'assign', faces: [0, 999], part: 1 }, 'faces'],
    [{ kind: 'split', part: 3, into: 2 }, 'part'],
    [{ kind: 'merge', parts: [1, 3] }, 'part'],
    [{ kind: 'unpin', piece: 7 }, 'piece'],
  ])('has no place for %o', (edit, what) => {
    const lost = { code: 'edit-place-gone', params: { what } };
    expect(movedEdit(edit, match, before, after)).toEqual(lost);
  });

  it('lays no piece where one of another size lay', () => {
    const pieces = after.pieces.map((piece) => ({ ...piece, width: 1.1 * piece.width }));
    const place = { kind: 'place', piece: 1, sheet: 1, x_mm: 1, y_mm: 1, turn_deg: 0 } as const;
    const lost = { code: 'edit-place-gone', params: { what: 'piece' } };
    expect(movedEdit(place, match, before, { ...after, pieces })).toEqual(lost);
  });

  it('merges no parts that have become one', () => {
    const labels = new Int32Array(after.labels.length);
    expect(
      movedEdit({ kind: 'merge', parts: [1, 2] }, match, before, { ...after, labels }),
    ).toEqual({
      code: 'edit-place-gone',
      params: { what: 'part' },
    });
  });
});
