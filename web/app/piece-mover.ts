import type { DocumentEdit } from '../model/document-edits.js';
import { layingOf, placing } from '../model/piece-edits.js';
import { PieceMove } from '../model/piece-move.js';
import type { PiecePlace } from '../model/piece-shape.js';
import type { SheetPieces } from '../model/sheet-pieces.js';
import { drawGhost, type Ghost } from '../view/piece-ghost.js';
import { phraseOf } from '../words/phrase.js';
import type { Ending } from './ending.js';
import { Panel } from './panel.js';
import { cannotStay, notDropped } from './piece-words.js';
import type { StudioPlace } from './place.js';
import { sentence } from './sentence.js';
import { SheetDrag } from './sheet-drag.js';
import type { SheetList } from './sheet-list.js';
import type { SheetPlace } from './sheet-place.js';
import type { Store } from './store.js';

/** How near an edge of what can be printed on attracts a piece: in mm, but at least in pixels. */
const attraction = { mm: 2, pixels: 6 };

/** Ms after the last step of a piece until it is laid down: steps that follow each other are one change. */
const pause = 600;

export interface PieceMoverListener {
  /** The piece that a hand may take up at a place, by its index; null if there is none. */
  liftable(place: SheetPlace, isFinger: boolean): number | null;
  /** A hand takes a piece up. */
  onLift(piece: number): void;
  /** A piece is on its way, or not any more. */
  onMove(): void;
  /** Makes an edit, and tells it by these words. */
  change(edit: DocumentEdit, words: string): Promise<Ending>;
  /** Says what came of the way of a piece. */
  tell(piece: number, words: string): void;
}

/** Takes pieces to other places, in a hand or step by step, and lays them down there as edits of the document. */
export class PieceMover extends Panel {
  private readonly layer = this.find('#piece-ghost', SVGSVGElement);
  private pieces: SheetPieces | null = null;
  private move: PieceMove | null = null;
  /** How the piece is on its way: in a hand, step by step, or being laid down. */
  private phase: 'held' | 'stepping' | 'laying' = 'stepping';
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly sheets: SheetList,
    private readonly listener: PieceMoverListener,
  ) {
    super(place);
    new SheetDrag(place, (event) => sheets.nearestPlace(event), {
      isLiftable: (at, isFinger) => !this.isBusy && listener.liftable(at, isFinger) !== null,
      lift: (at) => this.lift(at),
      follow: (at) => this.follow(at),
      turn: (degrees) => {
        this.move?.turn(degrees);
        this.draw();
      },
      drop: () => this.drop(),
      cancel: () => this.putBack(),
    });
    place.life.addEventListener('abort', () => clearTimeout(this.timer));
    // Sheets have another size, and so has what lies over them.
    new ResizeObserver(() => this.draw()).observe(this.layer);
    store.on('work', () => {
      // Another change has begun: what is on its way belongs to the result before.
      if (store.work !== 'idle' && this.phase !== 'laying') this.putBack();
    });
  }

  /** Takes another result. */
  offer(pieces: SheetPieces): void {
    this.pieces = pieces;
    this.putBack();
  }

  /** The piece that is on its way, by its index; null if there is none. */
  get piece(): number | null {
    return this.move?.piece ?? null;
  }

  /** Where it is. */
  get at(): PiecePlace | null {
    return this.move?.place ?? null;
  }

  get isHeld(): boolean {
    return this.move !== null && this.phase === 'held';
  }

  /** Whether it is where it cannot be laid down. */
  get isStuck(): boolean {
    return this.move !== null && this.move.fault !== null;
  }

  /** Moves or turns a piece by a step; it is laid down when no other one follows. */
  step(piece: number, change: (move: PieceMove) => void): void {
    const move = this.begin(piece);
    if (!move) return;
    change(move);
    this.draw();
    const { fault } = move;
    this.listener.tell(
      piece,
      fault && this.pieces ? cannotStay(this.told, this.pieces, piece, fault) : '',
    );
    this.listener.onMove();
    this.timer = setTimeout(() => {
      if (!this.isStuck) void this.lay();
    }, pause);
  }

  /** Takes a piece to where there is room on a sheet, from 0, and lays it down. */
  async takeTo(piece: number, sheet: number): Promise<void> {
    const move = this.begin(piece);
    if (!move || !this.pieces) return;
    if (move.findRoom(sheet)) return this.lay();
    this.putBack();
    this.listener.tell(
      piece,
      this.told.pieces.noRoom(this.pieces.result.pieces[piece]!.name, sheet + 1),
    );
  }

  /** Lays down what is on its way, or puts it back where it lay if it cannot stay. */
  async finish(): Promise<void> {
    if (this.phase !== 'stepping') return;
    if (this.isStuck) this.putBack();
    else await this.lay();
  }

  private get isBusy(): boolean {
    return this.store.busy || this.phase === 'laying';
  }

  private begin(piece: number): PieceMove | null {
    if (!this.pieces || this.isBusy) return null;
    clearTimeout(this.timer);
    if (this.move?.piece !== piece) this.move = new PieceMove(this.pieces, piece);
    return this.move;
  }

  private lift(place: SheetPlace): void {
    const piece = this.listener.liftable(place, false);
    if (piece === null) return;
    this.listener.onLift(piece);
    const move = this.begin(piece);
    if (!move) return;
    move.grab(place);
    this.phase = 'held';
    this.listener.onMove();
  }

  private follow({ sheet, point, mmPerPixel }: SheetPlace): void {
    const reach = Math.max(attraction.mm, attraction.pixels * mmPerPixel);
    this.move?.follow({ sheet, point }, reach);
    this.draw();
  }

  private drop(): void {
    const { move, pieces } = this;
    if (!move || !pieces) return;
    const { fault } = move;
    if (!fault) return void this.lay();
    this.putBack();
    this.listener.tell(move.piece, notDropped(this.told, pieces, move.piece, fault));
  }

  private async lay(): Promise<void> {
    const { move, pieces } = this;
    if (!move || !pieces) return;
    clearTimeout(this.timer);
    // What was said of the way to here is over.
    this.listener.tell(move.piece, '');
    if (!move.isAway) return this.putBack();
    this.phase = 'laying';
    this.draw();
    const own = pieces.result.pieces[move.piece]!;
    const words = this.told.pieces.laid[layingOf(own, move.place)](own.name);
    const ending = await this.listener.change(placing(move.piece, move.place), words);
    if (this.move === move) this.putBack();
    if (ending.type === 'refused') {
      this.listener.tell(move.piece, sentence(phraseOf(this.told, ending.refusal)));
    }
  }

  private putBack(): void {
    clearTimeout(this.timer);
    const wasAway = this.move !== null;
    this.move = null;
    this.phase = 'stepping';
    this.draw();
    if (wasAway) this.listener.onMove();
  }

  private draw(): void {
    drawGhost(this.layer, this.ghost);
  }

  private get ghost(): Ghost | null {
    const { move, pieces, sheets } = this;
    if (!move || !pieces) return null;
    const sheet = sheets.pictureOf(move.place.sheet);
    const outline = sheets.outlineOf(pieces.result.pieces[move.piece]!.name);
    if (!sheet || outline === null) return null;
    const free = this.phase === 'laying' ? 'waiting' : 'free';
    return { outline, motion: move.motion, sheet, state: move.fault ? 'refused' : free };
  }
}
