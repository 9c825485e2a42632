import type { DocumentEdit } from '../model/document-edits.js';
import { isPinOf, joinOffers, placing } from '../model/piece-edits.js';
import { pieceFlapEdits, type PieceFlaps } from '../model/piece-flaps.js';
import { placeOf } from '../model/piece-shape.js';
import { SheetEdges } from '../model/sheet-edges.js';
import { SheetPieces } from '../model/sheet-pieces.js';
import { phraseOf } from '../words/phrase.js';
import type { Ending } from './ending.js';
import type { FinishedRun } from './finished-run.js';
import { Panel } from './panel.js';
import { PieceCard, type PieceCardContent } from './piece-card.js';
import { PieceMover } from './piece-mover.js';
import { pieceWords } from './piece-words.js';
import { pinSigns } from './pin-places.js';
import type { StudioPlace } from './place.js';
import { finishedParts } from './result-words.js';
import { sentence } from './sentence.js';
import { followWork } from './sheet-choice.js';
import type { SheetList } from './sheet-list.js';
import type { SheetPlace } from './sheet-place.js';
import type { Store } from './store.js';

export interface PieceToolListener {
  /** Lights faces of the model, in place of those before. */
  lightFaces(faces: Int32Array): void;
  /** Makes edits in one go, and tells them by these words, or by what has become of the result. */
  change(edits: readonly DocumentEdit[], words?: string): Promise<Ending>;
  /** A piece is chosen or taken up: nothing else is chosen any more. */
  alone(): void;
  /** Whether a press at a place is for something else than pieces. */
  isTaken(place: SheetPlace, isFinger: boolean): boolean;
}

/** Pieces on the sheets are pointed at, chosen by a click, by keys or by their name, and changed. */
export class PieceTool extends Panel {
  private readonly line = this.find('#piece-line', HTMLElement);
  private readonly list = this.find('#sheets', HTMLOListElement);
  private readonly said = this.find('#piece-said', HTMLElement);
  private readonly card: PieceCard;
  private readonly mover: PieceMover;
  private run: FinishedRun | null = null;
  private pieces: SheetPieces | null = null;
  private pointed: number | null = null;
  private chosen: number | null = null;
  /** The piece that is being changed. */
  private waiting: number | null = null;
  private outcome = '';
  /** Searches for other nets so far: each has a seed of its own. */
  private searches = 0;

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly sheets: SheetList,
    private readonly listener: PieceToolListener,
  ) {
    super(place);
    this.card = this.makeCard();
    this.mover = new PieceMover(place, store, sheets, {
      // A finger takes up only what is chosen: elsewhere it scrolls the page.
      liftable: (at, isFinger) => {
        const piece = listener.isTaken(at, isFinger) ? null : this.pieceAt(at);
        return isFinger && piece !== this.chosen ? null : piece;
      },
      onLift: (piece) => {
        listener.alone();
        // A card that was open goes on with the piece in the hand.
        if (this.chosen !== null) this.choose(piece);
      },
      onMove: () => this.show(),
      change: (edit, words) => listener.change([edit], words),
      tell: (piece, words) => this.tell(piece, words),
    });
    this.list.addEventListener('keydown', (event) => this.walk(event));
    followWork(place, store, { close: () => this.close(), show: () => this.show() });
  }

  /** Takes another result; a piece that was chosen and is there still stays so. */
  offer(run: FinishedRun): void {
    const face = this.chosen === null ? null : this.facesOf(this.chosen)[0]!;
    this.waiting = null;
    this.run = run;
    this.pieces = new SheetPieces(run.result, run.settings.margin);
    this.chosen = face === null ? null : this.pieceWith(face);
    this.pointAt(null);
    this.mover.offer(this.pieces);
    this.sheets.pin(pinSigns(this.told.pieces.staysHere, run.result, run.pins));
    this.show();
  }

  /** Lights the piece at a place, and says what it is. */
  point(place: SheetPlace | null): void {
    this.pointAt(place && this.pieceAt(place));
  }

  /** Lights the piece of a face of the model. */
  pointAtFace(face: number): void {
    this.pointAt(this.pieceWith(face));
  }

  /** Chooses the piece at a place, or none; `adds`: chooses its part beside others, or no longer. */
  press(place: SheetPlace | null, adds: boolean): void {
    const piece = place && this.pieceAt(place);
    if (piece === null) this.close();
    else if (adds) this.store.toggle(this.partOf(piece));
    else {
      this.choose(piece);
      if (place) this.card.keepOff(place.below);
    }
  }

  /** The same with the piece of a face of the model. */
  pressFace(face: number, adds: boolean): void {
    const piece = this.pieceWith(face);
    if (piece === null) return;
    if (adds) this.store.toggle(this.partOf(piece));
    else this.choose(piece);
  }

  /** Chooses the piece of this name, in large or small letters; false if there is none. */
  findNamed(text: string): boolean {
    const names = this.pieces?.result.pieces.map(({ name }) => name.toLowerCase()) ?? [];
    const piece = names.indexOf(text.toLowerCase());
    if (piece < 0) return false;
    this.choose(piece);
    this.card.keepOff(this.sheets.revealPiece(this.nameOf(piece)));
    return true;
  }

  /** Chooses no piece any more. */
  close(): void {
    if (this.chosen === null) return;
    if (this.card.hasFocus) this.list.focus({ preventScroll: true });
    void this.mover.finish();
    const { selection } = this.store;
    const isOwn = selection.length === 1 && selection[0] === this.partOf(this.chosen);
    this.chosen = null;
    if (isOwn) this.store.select([]);
    this.show();
  }

  private makeCard(): PieceCard {
    const chosen = (action: (piece: number) => void) => (): void => {
      if (this.chosen !== null) action(this.chosen);
    };
    return new PieceCard(this.place, {
      turn: (degrees) => chosen((piece) => this.mover.step(piece, (move) => move.turn(degrees)))(),
      nudge: (right, up) =>
        chosen((piece) => this.mover.step(piece, (move) => move.nudge(right, up)))(),
      takeTo: (sheet) => chosen((piece) => void this.mover.takeTo(piece, sheet))(),
      findRoom: chosen((piece) => {
        void this.mover.takeTo(piece, this.mover.at?.sheet ?? this.sheetOf(piece));
      }),
      pin: (isPinned) => void this.pin(isPinned),
      rename: (text) => void this.change((part) => ({ kind: 'name', part, text })),
      setFlaps: (where) => void this.setFlaps(where),
      split: () => void this.change((part) => ({ kind: 'split', part, into: 2 })),
      again: () => void this.change((part) => ({ kind: 'again', part, seed: this.nextSeed() })),
      join: (other) => void this.change((part) => ({ kind: 'merge', parts: [part, other + 1] })),
      close: () => this.close(),
    });
  }

  private choose(piece: number): void {
    if (piece !== this.chosen) {
      void this.mover.finish();
      this.outcome = '';
    }
    this.chosen = piece;
    this.listener.alone();
    this.store.select([this.partOf(piece)]);
    this.show();
  }

  private tell(piece: number, words: string): void {
    if (words !== '' && piece !== this.chosen) this.choose(piece);
    this.outcome = words;
    this.show();
  }

  /** Left and right go to the piece before and the next one, Enter chooses it. */
  private walk(event: KeyboardEvent): void {
    const { pieces, pointed, chosen } = this;
    if (!pieces || event.target !== this.list) return;
    const count = pieces.result.pieces.length;
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (by !== undefined && count > 0) {
      event.preventDefault();
      const from = pointed ?? chosen ?? (by > 0 ? -1 : 0);
      const piece = (from + by + count) % count;
      this.pointAt(piece);
      this.sheets.revealPiece(this.nameOf(piece));
      this.said.textContent = pieceWords(this.told, pieces, piece);
    } else if (event.key === 'Enter' && pointed !== null) {
      event.preventDefault();
      this.choose(pointed);
      this.card.keepOff(this.sheets.revealPiece(this.nameOf(pointed)));
      this.card.focus();
    }
  }

  private async pin(isPinned: boolean): Promise<void> {
    await this.mover.finish();
    const { pieces, chosen } = this;
    if (!pieces || chosen === null) return;
    const own = pieces.result.pieces[chosen]!;
    const { pieces: told } = this.told;
    const words = isPinned ? told.laid.kept(own.name) : told.mayMove(own.name);
    const edit: DocumentEdit = isPinned
      ? placing(chosen, placeOf(own))
      : { kind: 'unpin', piece: chosen + 1 };
    await this.follow(this.listener.change([edit], words));
  }

  /** Changes the part of the chosen piece, from 1. */
  private async change(edit: (part: number) => DocumentEdit): Promise<void> {
    await this.mover.finish();
    if (this.chosen === null) return;
    await this.follow(this.listener.change([edit(this.partOf(this.chosen) + 1)]));
  }

  /** Puts all flaps of the chosen piece where they shall be. */
  private async setFlaps(where: PieceFlaps): Promise<void> {
    await this.mover.finish();
    const { run, chosen } = this;
    if (!run || chosen === null) return;
    const edits = pieceFlapEdits(new SheetEdges(run.result), chosen, where);
    if (edits.length > 0) await this.follow(this.listener.change(edits));
  }

  /** Says why a change was not made. */
  private async follow(change: Promise<Ending>): Promise<void> {
    const { chosen } = this;
    this.outcome = '';
    this.waiting = chosen;
    this.show();
    const ending = await change;
    this.waiting = null;
    if (ending.type === 'refused' && this.chosen === chosen) {
      this.outcome = sentence(phraseOf(this.told, ending.refusal));
    }
    this.show();
  }

  private nextSeed(): number {
    this.searches += 1;
    return (this.run?.settings.seed ?? 0) + this.searches;
  }

  private pointAt(piece: number | null): void {
    if (piece === this.pointed) return;
    this.pointed = piece;
    this.line.textContent =
      piece === null || !this.pieces ? '' : pieceWords(this.told, this.pieces, piece);
    this.light();
  }

  private show(): void {
    this.light();
    this.card.show(this.mover.isHeld ? null : this.content);
  }

  private get content(): PieceCardContent | null {
    const { pieces, run, chosen, mover, outcome } = this;
    if (!pieces || !run || chosen === null) return null;
    const { result, pins } = run;
    const own = result.pieces[chosen]!;
    const place = mover.piece === chosen ? mover.at : null;
    const isPinned = pins.some((pin) => isPinOf(pin, own));
    const words = `${pieceWords(this.told, pieces, chosen, place ?? undefined)}.`;
    const name = this.store.names.find(({ part }) => part === own.part)?.name ?? '';
    return {
      words: isPinned ? `${words} ${this.told.pieces.staysHere}` : words,
      // Without all nets a job would go on to search, which a name must not.
      name: finishedParts(result) === result.parts ? name : null,
      sheet: place?.sheet ?? own.sheet,
      sheets: result.sheets.length,
      isPinned,
      joins: joinOffers(result, own.part),
      isStuck: place !== null && mover.isStuck,
      busy: this.store.busy,
      outcome,
    };
  }

  private light(): void {
    const { chosen, pointed, mover } = this;
    const name = (piece: number | null): string | null =>
      piece === null ? null : this.nameOf(piece);
    this.sheets.lightPieces({
      chosen: name(chosen),
      pointed: name(pointed),
      lifted: name(mover.piece),
      waiting: name(this.waiting),
    });
    const lit = pointed ?? chosen;
    this.listener.lightFaces(lit === null ? new Int32Array() : this.facesOf(lit));
  }

  private pieceAt({ sheet, point }: SheetPlace): number | null {
    return this.pieces?.at(sheet, point) ?? null;
  }

  private pieceWith(face: number): number | null {
    const { pieces } = this.run?.result ?? { pieces: [] };
    const found = pieces.findIndex(({ sources }) => sources.includes(face));
    return found < 0 ? null : found;
  }

  private facesOf(piece: number): Int32Array {
    return this.run!.result.pieces[piece]!.sources;
  }

  private nameOf(piece: number): string {
    return this.run!.result.pieces[piece]!.name;
  }

  private partOf(piece: number): number {
    return this.run!.result.pieces[piece]!.part;
  }

  private sheetOf(piece: number): number {
    return this.run!.result.pieces[piece]!.sheet;
  }
}
