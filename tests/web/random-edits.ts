/** Random edits of a document, from a seed. */
import type { DocumentEdit } from '../../web/model/document-edits.js';
import type { JobResult } from '../../web/model/job.js';

/** A generator of random numbers that is the same everywhere. */
export class Dice {
  constructor(private state: number) {}

  /** In [0, 1). */
  roll(): number {
    this.state = (this.state + 0x6d2b79f5) >>> 0;
    let t = this.state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  }

  below(count: number): number {
    return Math.floor(this.roll() * count);
  }

  of<Item>(items: readonly Item[]): Item {
    return items[this.below(items.length)]!;
  }
}

/** An edge of the model's faces. */
function someEdge(dice: Dice, { model }: JobResult): [number, number] {
  const face = dice.below(model.faces.length / 3);
  const corner = dice.below(3);
  return [model.faces[3 * face + corner]!, model.faces[3 * face + ((corner + 1) % 3)]!];
}

/** Edges that a piece has cut, or folds, as vertices of the model. */
function edgeOfPiece(
  dice: Dice,
  { model, pieces }: JobResult,
  isCut: boolean,
): [number, number] | null {
  const piece = dice.of(pieces);
  const wanted = [...piece.assignments].flatMap((letter, e) =>
    (letter === 'B') === isCut ? [e] : [],
  );
  if (wanted.length === 0) return null;
  const edge = dice.of(wanted);
  const ends = [piece.edges[2 * edge], piece.edges[2 * edge + 1]];
  for (let at = 0; at < piece.faces.length; ++at) {
    const next = at % 3 === 2 ? at - 2 : at + 1;
    if (piece.faces[at] !== ends[0] || piece.faces[next] !== ends[1]) continue;
    const first = 3 * piece.sources[Math.floor(at / 3)]!;
    return [model.faces[first + (at % 3)]!, model.faces[first + (next % 3)]!];
  }
  return null;
}

/** Some edit, not always one that can be made. */
export function randomEdit(dice: Dice, result: JobResult): DocumentEdit {
  const part = 1 + dice.below(result.parts);
  const edge = (isCut: boolean): [number, number] =>
    edgeOfPiece(dice, result, isCut) ?? someEdge(dice, result);
  const makers: (() => DocumentEdit)[] = [
    () => ({ kind: 'split', part, into: 2 }),
    () => ({ kind: 'merge', parts: [part, 1 + dice.below(result.parts)] }),
    () => ({ kind: 'cut', edge: edge(false) }),
    () => ({ kind: 'cut', edge: edge(false) }),
    () => ({ kind: 'join', edge: edge(true), search: dice.roll() < 0.3 }),
    () => ({ kind: 'join', edge: edge(true) }),
    () => ({ kind: 'assign', faces: [dice.below(result.labels.length)], part }),
    () => ({ kind: 'flap', edge: edge(true), side: dice.of(['first', 'second', 'both', 'none']) }),
    () => ({ kind: 'flap', edge: edge(true), side: 'auto', height_mm: dice.of([2, 8, 20]) }),
    () => ({ kind: 'lock', edge: edge(dice.roll() < 0.5), as: dice.of(['fold', 'cut', 'free']) }),
    () => ({ kind: 'name', part, text: dice.of(['Nose', 'Wing', 'Tail', '']) }),
    () => {
      const piece = dice.below(result.pieces.length);
      const { sheet, x, y, angle } = result.pieces[piece]!;
      const shift = dice.of([0, 1, 20]);
      return {
        kind: 'place',
        piece: piece + 1,
        sheet: sheet + 1,
        x_mm: x + shift,
        y_mm: y,
        turn_deg: angle,
      };
    },
    () => ({ kind: 'unpin', piece: 1 + dice.below(result.pieces.length) }),
    () => ({ kind: 'paper', options: { paper: dice.of(['A4', 'A3']) } }),
    () => ({ kind: 'paper', options: { ids: dice.of(['both', 'inside']) } }),
    () => ({ kind: 'print', options: { style: dice.of(['pepakura', 'foldwright']) } }),
  ];
  return dice.of(makers)();
}
