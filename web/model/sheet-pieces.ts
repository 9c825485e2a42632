import type { JobResult, Sheet } from './job.js';
import {
  isOn,
  isWithin,
  overlap,
  placeOf,
  PieceShape,
  type PiecePlace,
  type PlacedShape,
} from './piece-shape.js';
import type { SheetPoint } from './sheet-edges.js';
import { roomOn, type Area } from './sheet-room.js';

/** Why a piece cannot lie at a place. */
export type PlaceFault =
  /** It sticks out of what can be printed on. */
  | { what: 'outside' }
  /** It lies on another piece, by its index. */
  | { what: 'overlap'; piece: number };

/** How far apart the places are at which room is looked for, mm. */
const stride = 4;

/** The nearest number in a range, or its middle if there is no such number. */
function clamped(value: number, least: number, most: number): number {
  return least > most ? (least + most) / 2 : Math.min(Math.max(value, least), most);
}

/** The numbers from one to another, in strides, with both ends. */
function strides(from: number, to: number): number[] {
  const count = Math.ceil((to - from) / stride);
  return Array.from({ length: Math.max(0, count) + 1 }, (_, i) => Math.min(from + i * stride, to));
}

/** The pieces of a result where they lie on their sheets, and where else each of them could lie. */
export class SheetPieces {
  private readonly shapes: readonly PieceShape[];
  private readonly placed: readonly PlacedShape[];

  /** @param margin around each sheet, mm */
  constructor(
    readonly result: JobResult,
    private readonly margin: number,
  ) {
    this.shapes = result.pieces.map((piece) => new PieceShape(piece));
    this.placed = result.pieces.map((piece, i) => this.shapes[i]!.at(placeOf(piece)));
  }

  /** The piece at a point of a sheet, by its index; null if there is none. */
  at(sheet: number, point: SheetPoint): number | null {
    const found = this.placed.findIndex(
      (shape, i) => this.result.pieces[i]!.sheet === sheet && isOn(shape, point),
    );
    return found < 0 ? null : found;
  }

  shape(piece: number): PieceShape {
    return this.shapes[piece]!;
  }

  /** Width and height in mm that a piece takes at a place. */
  sizeAt(piece: number, place: PiecePlace): readonly [width: number, height: number] {
    const { left, bottom, right, top } = this.shape(piece).at(place).box;
    return [right - left, top - bottom];
  }

  /** Where pieces may lie on a sheet. A sheet that is not there yet is like the others. */
  room(sheet: number): Area {
    const { sheets } = this.result;
    const like: Sheet | undefined = sheets[sheet] ?? sheets[0];
    return roomOn(like ?? { width: 0, height: 0 }, this.margin);
  }

  /** What is wrong with a place for a piece; null if it could lie there and all others stay. */
  faultAt(piece: number, place: PiecePlace): PlaceFault | null {
    const shape = this.shape(piece).at(place);
    if (!isWithin(shape.box, this.room(place.sheet))) return { what: 'outside' };
    const { pieces } = this.result;
    const other = this.placed.findIndex(
      (placed, i) => i !== piece && pieces[i]!.sheet === place.sheet && overlap(shape, placed),
    );
    return other < 0 ? null : { what: 'overlap', piece: other };
  }

  /** The place moved as little as takes the piece into what can be printed on, where that is large enough. */
  pulledIn(piece: number, place: PiecePlace): PiecePlace {
    const { left, bottom, right, top } = this.room(place.sheet);
    const [width, height] = this.sizeAt(piece, place);
    const [x, y] = [clamped(place.x, left, right - width), clamped(place.y, bottom, top - height)];
    return { ...place, x, y };
  }

  /**
   * The place nearest to a wanted one, on the same sheet and with the same turn, at which a piece can lie and all
   * others stay; to 4 mm. Null if none is found. Cost: some ten milliseconds on a full sheet.
   */
  freePlace(piece: number, wanted: PiecePlace): PiecePlace | null {
    const first = this.pulledIn(piece, wanted);
    const { left, bottom, right, top } = this.room(wanted.sheet);
    const [width, height] = this.sizeAt(piece, wanted);
    const places = strides(left, right - width).flatMap((x) =>
      strides(bottom, top - height).map((y) => ({ ...wanted, x, y })),
    );
    const away = ({ x, y }: PiecePlace): number => Math.hypot(x - wanted.x, y - wanted.y);
    places.sort((a, b) => away(a) - away(b));
    return [first, ...places].find((place) => this.faultAt(piece, place) === null) ?? null;
  }
}
