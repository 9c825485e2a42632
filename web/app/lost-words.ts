import type { CarriedEdits, LostEdit } from '../api/carry-edits.js';
import { boxOf } from '../model/bounds.js';
import type { DocumentEdit } from '../model/document-edits.js';
import type { Model } from '../model/job.js';
import { plus, times, vectorAt, type Vector } from '../model/vector.js';
import { phraseOf } from '../words/phrase.js';
import type { Words } from '../words/words.js';
import { editWords } from './edit-words.js';

/** Vertices of the model at which an edit was made; none for one that is not about a place. */
function verticesOf(edit: DocumentEdit, { faces }: Model): readonly number[] {
  if ('edge' in edit) return edit.edge;
  if (edit.kind !== 'assign') return [];
  return edit.faces.flatMap((face) => [...faces.subarray(3 * face, 3 * face + 3)]);
}

/** In which third of the model's box a point is along each axis: -1, 0 or 1. */
function thirdsOf(point: Vector, { vertices }: Model): Vector {
  const { low, high } = boxOf(vertices);
  const third = (axis: 0 | 1 | 2): number => {
    const share = (point[axis] - low[axis]) / Math.max(high[axis] - low[axis], Number.MIN_VALUE);
    return share < 1 / 3 ? -1 : share > 2 / 3 ? 1 : 0;
  };
  return [third(0), third(1), third(2)];
}

/** Where on the model an edit was made; null for one that is not about a place. */
function placeWords({ replacing }: Words, edit: DocumentEdit, model: Model): string | null {
  const vertices = verticesOf(edit, model);
  if (vertices.length === 0) return null;
  const points = vertices.map((vertex) => vectorAt(model.vertices, vertex));
  const middle = times(points.reduce(plus), 1 / points.length);
  return replacing.near(thirdsOf(middle, model));
}

/** A sentence about an edit that was not made again, and why. */
function lostSentence(words: Words, { edit, before, reason }: LostEdit): string {
  const name = editWords(words, [edit], before);
  const place = placeWords(words, edit, before.model);
  return words.replacing.lost(name, place, phraseOf(words, reason));
}

/** A headline and a sentence for each edit that was not made again; empty if all were. */
export function lostWords(words: Words, { lost }: CarriedEdits): string[] {
  if (lost.length === 0) return [];
  return [words.replacing.headline(lost.length), ...lost.map((one) => lostSentence(words, one))];
}
