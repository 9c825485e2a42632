/** Takes edits of a result over to the result of a corrected model. */
import type { DocumentEdit } from './document-edits.js';
import type { EdgeName, JobResult, Piece } from './job.js';
import type { Message } from './message.js';
import type { ModelMatch } from './model-match.js';

/** What edits name in a result. */
export type EditedResult = Pick<JobResult, 'labels' | 'pieces'>;

/** What is not there any more where an edit was made. */
export type LostPlace = 'edge' | 'faces' | 'part' | 'piece';

/** An edit that does not fit. */
class Lost extends Error {
  constructor(readonly what: LostPlace) {
    super(what);
  }
}

/** How much a net may differ in width and height to be laid where another one lay. */
const sameSize = 0.05;

/** Per face: the number of its piece, -1 for none. */
function piecesOfFaces({ labels, pieces }: EditedResult): Int32Array {
  const numbers = new Int32Array(labels.length).fill(-1);
  pieces.forEach(({ sources }, piece) => sources.forEach((face) => (numbers[face] = piece)));
  return numbers;
}

function isAlike(one: Piece, other: Piece): boolean {
  const differs = (a: number, b: number): boolean => Math.abs(a - b) > sameSize * Math.max(a, b);
  return !differs(one.width, other.width) && !differs(one.height, other.height);
}

class Mover {
  constructor(
    private readonly match: ModelMatch,
    private readonly before: EditedResult,
    private readonly after: EditedResult,
  ) {}

  move(edit: DocumentEdit): DocumentEdit {
    switch (edit.kind) {
      case 'cut':
      case 'lock':
      case 'flap':
        return { ...edit, edge: this.edge(edit.edge) };
      case 'join': {
        const { open, ...rest } = edit;
        return { ...rest, edge: this.edge(edit.edge), ...(open && { open: this.edge(open) }) };
      }
      case 'assign':
        return { ...edit, faces: this.faces(edit.faces), part: this.part(edit.part) };
      case 'split':
      case 'again':
      case 'name':
        return { ...edit, part: this.part(edit.part) };
      case 'merge':
        return { ...edit, parts: this.parts(edit.parts) };
      case 'place':
        return { ...edit, piece: this.samePiece(edit.piece) };
      case 'unpin':
        return { ...edit, piece: this.piece(edit.piece) };
      case 'paper':
      case 'print':
        return edit;
    }
  }

  private edge(edge: EdgeName): EdgeName {
    return this.found(this.match.edge(edge), 'edge');
  }

  private faces(faces: readonly number[]): number[] {
    return this.found(this.match.faces(faces), 'faces');
  }

  private part(part: number): number {
    const { before, after } = this;
    return 1 + this.found(this.match.group(part - 1, before.labels, after.labels), 'part');
  }

  private parts(parts: readonly number[]): number[] {
    const found = [...new Set(parts.map((part) => this.part(part)))];
    if (found.length < parts.length) throw new Lost('part');
    return found;
  }

  private piece(piece: number): number {
    const { before, after } = this;
    const group = this.match.group(piece - 1, piecesOfFaces(before), piecesOfFaces(after));
    return 1 + this.found(group, 'piece');
  }

  /** A piece that has the room that the other one had. */
  private samePiece(piece: number): number {
    const found = this.piece(piece);
    const [one, other] = [this.before.pieces[piece - 1]!, this.after.pieces[found - 1]!];
    if (!isAlike(one, other)) throw new Lost('piece');
    return found;
  }

  private found<Value>(value: Value | null, what: LostPlace): Value {
    if (value === null) throw new Lost(what);
    return value;
  }
}

/**
 * An edit as it is for the result of a corrected model, or why there is no place for it there.
 *
 * @param before the result in which the edit was made
 * @param after the one in which it is to be made
 */
export function movedEdit(
  edit: DocumentEdit,
  match: ModelMatch,
  before: EditedResult,
  after: EditedResult,
): DocumentEdit | Message {
  try {
    return new Mover(match, before, after).move(edit);
  } catch (error) {
    if (!(error instanceof Lost)) throw error;
    return { code: 'edit-place-gone', params: { what: error.what } };
  }
}
