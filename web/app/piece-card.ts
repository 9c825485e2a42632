import type { PartOffer } from '../model/piece-edits.js';
import { pieceFlaps, type PieceFlaps } from '../model/piece-flaps.js';
import { make } from './dom.js';
import type { StudioPlace } from './place.js';
import { onPress } from './press.js';
import { SheetCard } from './sheet-card.js';
import { WrittenField } from './written-field.js';

/** Degrees and mm of one press, and of one with Shift. */
const fineTurn = { plain: 5, shift: 1 };
const step = { plain: 1, shift: 10 };

/** Where arrows lead: to the right, and up. */
const arrows: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** What the card says and offers. */
export interface PieceCardContent {
  words: string;
  /** The name that a person has given it, or is about to; null if it can have none now. */
  name: string | null;
  /** Where it is, from 0, and how many sheets there are. */
  sheet: number;
  sheets: number;
  /** Whether it stays where it is. */
  isPinned: boolean;
  /** What it can be joined with. */
  joins: readonly PartOffer[];
  /** Whether it is at a place where it cannot stay. */
  isStuck: boolean;
  /** Whether changes have to wait. */
  busy: boolean;
  /** What came of the last change, or why it was not made. */
  outcome: string;
}

export interface PieceCardListener {
  /** Degrees, counter-clockwise. */
  turn(degrees: number): void;
  /** mm. */
  nudge(right: number, up: number): void;
  /** To a sheet, from 0; one behind the last is a new one. */
  takeTo(sheet: number): void;
  /** Somewhere on its sheet where there is room. */
  findRoom(): void;
  /** It shall stay where it is, or need not any more. */
  pin(isPinned: boolean): void;
  rename(name: string): void;
  setFlaps(where: PieceFlaps): void;
  split(): void;
  again(): void;
  /** With a part, from 0. */
  join(part: number): void;
  close(): void;
}

/** The card of the piece that is chosen. */
export class PieceCard extends SheetCard {
  private readonly words = this.find('#piece-words', HTMLElement);
  private readonly nameField = this.find('#piece-name', HTMLInputElement);
  private readonly name = new WrittenField(this.nameField, (text) => this.listener.rename(text));
  private readonly nameLabel = this.find('#piece-name-label', HTMLElement);
  private readonly sheet = this.find('#piece-sheet', HTMLSelectElement);
  private readonly pin = this.find('#piece-pin', HTMLButtonElement);
  private readonly joining = this.find('#piece-joining', HTMLElement);
  private readonly partner = this.find('#piece-partner', HTMLSelectElement);
  private readonly room = this.find('#piece-room', HTMLButtonElement);
  private readonly outcome = this.find('#piece-outcome', HTMLElement);
  /** What has to wait while something else changes. */
  private readonly buttons: readonly HTMLButtonElement[];
  private content: PieceCardContent | null = null;

  constructor(
    place: StudioPlace,
    private readonly listener: PieceCardListener,
  ) {
    super(place, '#piece-card');
    const button = (id: string, action: () => void): HTMLButtonElement => {
      const found = this.find(id, HTMLButtonElement);
      onPress(found, action);
      return found;
    };
    onPress(this.pin, () => listener.pin(!this.content?.isPinned));
    this.buttons = [
      this.pin,
      button('#piece-split', () => listener.split()),
      button('#piece-again', () => listener.again()),
      button('#piece-join', () => listener.join(Number(this.partner.value))),
      ...this.flapButtons(),
    ];
    button('#piece-room', () => listener.findRoom());
    button('#piece-close', () => listener.close());
    this.sheet.addEventListener('change', () => listener.takeTo(Number(this.sheet.value)));
    this.hearMoves();
  }

  /** Shows a piece, or nothing. */
  show(content: PieceCardContent | null): void {
    this.content = content;
    this.card.hidden = content === null;
    if (!content) return this.name.forget();
    this.change(() => this.fill(content));
  }

  /** Moves the keyboard here. */
  focus(): void {
    this.card.focus({ preventScroll: true });
  }

  private fill(content: PieceCardContent): void {
    const { pieces: told, speech } = this.told;
    this.words.textContent = content.words;
    this.nameLabel.hidden = content.name === null;
    this.nameField.readOnly = content.busy;
    this.name.show(content.name ?? '');
    this.fillSheets(content);
    this.pin.textContent = content.isPinned ? told.letMove : told.keepHere;
    this.joining.hidden = content.joins.length === 0;
    const { value } = this.partner;
    this.partner.replaceChildren(
      ...content.joins.map(({ part, pieces }) =>
        make('option', { value: String(part), textContent: speech.all(pieces) }),
      ),
    );
    // Who has chosen one finds it chosen still.
    if (content.joins.some(({ part }) => String(part) === value)) this.partner.value = value;
    this.room.hidden = !content.isStuck;
    this.outcome.textContent = content.outcome;
    for (const one of this.buttons) one.setAttribute('aria-disabled', String(content.busy));
  }

  private fillSheets({ sheet, sheets }: PieceCardContent): void {
    const options = Array.from({ length: Math.max(sheets, sheet + 1) }, (_, i) =>
      make('option', { value: String(i), textContent: String(i + 1) }),
    );
    const more = make('option', {
      value: String(options.length),
      textContent: this.told.pieces.newSheet,
    });
    this.sheet.replaceChildren(...options, more);
    this.sheet.value = String(sheet);
  }

  private hearMoves(): void {
    const { listener } = this;
    for (const button of this.card.querySelectorAll<HTMLButtonElement>('[data-turn]')) {
      const degrees = Number(button.dataset['turn']);
      const fine = Math.sign(degrees) * fineTurn.shift;
      const isFine = Math.abs(degrees) === fineTurn.plain;
      onPress(button, ({ shiftKey }) => listener.turn(isFine && shiftKey ? fine : degrees));
    }
    for (const button of this.card.querySelectorAll<HTMLButtonElement>('[data-arrow]')) {
      onPress(button, ({ shiftKey }) => this.move(button.dataset['arrow'] ?? '', shiftKey));
    }
    this.card.addEventListener('keydown', (event) => {
      const { target, key, shiftKey, ctrlKey, metaKey, altKey } = event;
      const isField = target instanceof HTMLInputElement || target instanceof HTMLSelectElement;
      if (isField || ctrlKey || metaKey || altKey || !arrows[key]) return;
      event.preventDefault();
      this.move(key, shiftKey);
    });
  }

  private move(arrow: string, isFar: boolean): void {
    const way = arrows[arrow];
    if (!way) return;
    const length = isFar ? step.shift : step.plain;
    this.listener.nudge(length * way[0], length * way[1]);
  }

  private flapButtons(): HTMLButtonElement[] {
    return pieceFlaps.map((where) => {
      const button = this.find(`#piece-card [data-flaps="${where}"]`, HTMLButtonElement);
      onPress(button, () => this.listener.setFlaps(where));
      return button;
    });
  }
}
