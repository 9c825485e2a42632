import { placeOf, type PieceMotion, type PiecePlace } from './piece-shape.js';
import { layingOf } from './piece-edits.js';
import type { SheetPoint } from './sheet-edges.js';
import type { PlaceFault, SheetPieces } from './sheet-pieces.js';
import { snappedPlace } from './snapped-place.js';

/** Where on the sheets something is held. */
export interface Hold {
  sheet: number;
  point: SheetPoint;
}

/** A piece on its way to another place. Nothing else changes until it is laid down. */
export class PieceMove {
  /** Where it would be laid down now. */
  place: PiecePlace;
  /** Where it is held, and how far its lower left is from there. */
  private hold: Hold | null = null;
  private offset: SheetPoint = [0, 0];

  constructor(
    private readonly pieces: SheetPieces,
    readonly piece: number,
  ) {
    this.place = placeOf(pieces.result.pieces[piece]!);
  }

  /** Why it cannot be laid down; null if it can. */
  get fault(): PlaceFault | null {
    return this.pieces.faultAt(this.piece, this.place);
  }

  /** Whether it has left the place where it lay. */
  get isAway(): boolean {
    return layingOf(this.pieces.result.pieces[this.piece]!, this.place) !== 'kept';
  }

  /** How it got where it is. */
  get motion(): PieceMotion {
    return this.pieces.shape(this.piece).motionTo(this.place);
  }

  /** Begins to follow a hand. */
  grab(hold: Hold): void {
    this.hold = hold;
    const { x, y } = this.place;
    this.offset = [x - hold.point[0], y - hold.point[1]];
  }

  /**
   * Follows the hand, on whole millimetres or along the edges of what can be printed on.
   *
   * @param reach of these edges, mm
   */
  follow(hold: Hold, reach: number): void {
    this.hold = hold;
    const [x, y] = [hold.point[0] + this.offset[0], hold.point[1] + this.offset[1]];
    const place = { ...this.place, sheet: hold.sheet, x, y };
    const size = this.pieces.sizeAt(this.piece, place);
    this.place = snappedPlace(place, size, this.pieces.room(hold.sheet), reach);
  }

  /** Turns it by so many degrees, counter-clockwise; what is not held stays within what can be printed on. */
  turn(degrees: number): void {
    const turned = this.pieces.shape(this.piece).turnedBy(this.place, degrees);
    this.place = this.hold ? turned : this.pieces.pulledIn(this.piece, turned);
    if (this.hold) this.grab(this.hold);
  }

  /** Moves it by so many mm. */
  nudge(right: number, up: number): void {
    this.place = { ...this.place, x: this.place.x + right, y: this.place.y + up };
  }

  /** Takes it to where there is room on a sheet, turned if need be; false if there is none. */
  findRoom(sheet: number): boolean {
    const wanted = { ...this.place, sheet };
    const across = this.pieces.shape(this.piece).turnedBy(wanted, 90);
    const found =
      this.pieces.freePlace(this.piece, wanted) ?? this.pieces.freePlace(this.piece, across);
    if (found) this.place = found;
    return found !== null;
  }
}
