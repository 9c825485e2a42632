import type { Pointing, Turn } from './model-message.js';

/** A drag as long as the picture is high goes once around. */
const fullTurn = 2 * Math.PI;

/** Angle of one press of a key in radians, and how much nearer one press of + comes. */
const keyAngle = Math.PI / 24;
const keyZoom = 0.9;

/** How much nearer a notch of the wheel comes, and its length in pixels, or in lines of that many. */
const wheelZoom = 0.95;
const wheelNotch = 100;
const wheelLine = 16;

const still: Turn = { around: 0, down: 0, away: 1 };

const keyTurns: Readonly<Record<string, Partial<Turn>>> = {
  ArrowLeft: { around: -keyAngle },
  ArrowRight: { around: keyAngle },
  ArrowUp: { down: -keyAngle },
  ArrowDown: { down: keyAngle },
  '+': { away: keyZoom },
  '-': { away: 1 / keyZoom },
};

/** Pixels that a hand may tremble between press and release. */
const tremble = 5;

export interface Point {
  x: number;
  y: number;
}

/** A stroke over the picture, with the turn that it would else be. */
export interface Stroke extends Point, Turn {
  phase: 'begin' | 'move' | 'end';
}

/** Who hears of hands; places are from -1 to 1, to the right and up. */
export interface HandListener {
  /** Is also called when the picture is grabbed, with a turn that moves nothing. */
  turn(turn: Turn): void;
  /** `place` is null when the mouse has left. */
  point(place: Point | null, why: Pointing): void;
  stroke(stroke: Stroke): void;
  /** Whether a drag is a stroke. */
  isPainting(): boolean;
}

/**
 * Makes turns of what hands do to a picture in its frame: drag, pinch, roll the wheel, press keys. A
 * click points at something; a drag may also be a stroke.
 */
export class TurnInput {
  /** Where mouse, pen and fingers hold the picture. */
  private readonly held = new Map<number, Point>();
  /** Where a press began that may still become a click. */
  private pressed: Point | null = null;
  /** Whether a stroke is being made. */
  private isStroke = false;

  constructor(
    private readonly frame: HTMLElement,
    private readonly listener: HandListener,
  ) {
    frame.addEventListener('pointerdown', (event) => this.grab(event));
    frame.addEventListener('pointermove', (event) => this.drag(event));
    frame.addEventListener('pointerup', (event) => this.release(event));
    frame.addEventListener('pointerleave', () => listener.point(null, 'over'));
    frame.addEventListener('pointercancel', (event) => {
      this.held.delete(event.pointerId);
      this.endStroke(event);
    });
    frame.addEventListener('wheel', (event) => this.roll(event), { passive: false });
    frame.addEventListener('keydown', (event) => this.press(event));
  }

  private turn(turn: Partial<Turn>): void {
    this.listener.turn({ ...still, ...turn });
  }

  /** From -1 to 1, to the right and up. */
  private placeOf({ clientX, clientY }: PointerEvent): Point {
    const { left, top, width, height } = this.frame.getBoundingClientRect();
    return { x: (2 * (clientX - left)) / width - 1, y: 1 - (2 * (clientY - top)) / height };
  }

  private stroke(phase: Stroke['phase'], event: PointerEvent, turn: Partial<Turn> = {}): void {
    this.listener.stroke({ phase, ...this.placeOf(event), ...still, ...turn });
  }

  private endStroke(event: PointerEvent): void {
    if (this.isStroke) this.stroke('end', event);
    this.isStroke = false;
  }

  private grab(event: PointerEvent): void {
    const { pointerId, clientX, clientY } = event;
    this.frame.focus({ preventScroll: true });
    this.frame.setPointerCapture(pointerId);
    this.held.set(pointerId, { x: clientX, y: clientY });
    this.pressed = this.held.size === 1 ? { x: clientX, y: clientY } : null;
    // A second finger makes a pinch of it.
    this.endStroke(event);
    if (this.pressed && this.listener.isPainting()) {
      this.isStroke = true;
      this.stroke('begin', event);
    } else this.turn({});
  }

  private release(event: PointerEvent): void {
    const { pointerId, clientX, clientY, shiftKey, ctrlKey, metaKey } = event;
    this.held.delete(pointerId);
    const { pressed, isStroke } = this;
    this.pressed = null;
    if (isStroke) return this.endStroke(event);
    if (!pressed || Math.hypot(clientX - pressed.x, clientY - pressed.y) > tremble) return;
    this.listener.point(this.placeOf(event), shiftKey || ctrlKey || metaKey ? 'add' : 'choose');
  }

  private drag(event: PointerEvent): void {
    const { pointerId, clientX, clientY, pointerType } = event;
    const from = this.held.get(pointerId);
    if (!from) {
      if (pointerType === 'mouse') this.listener.point(this.placeOf(event), 'over');
      return;
    }
    const to = { x: clientX, y: clientY };
    this.held.set(pointerId, to);
    const other = [...this.held].find(([id]) => id !== pointerId)?.[1];
    if (other) {
      const span = ({ x, y }: Point): number => Math.hypot(x - other.x, y - other.y) || 1;
      this.turn({ away: span(from) / span(to) });
      return;
    }
    const scale = fullTurn / this.frame.clientHeight;
    const turn = { around: scale * (from.x - to.x), down: scale * (from.y - to.y) };
    if (this.isStroke) this.stroke('move', event, turn);
    else this.turn(turn);
  }

  private roll(event: WheelEvent): void {
    // The wheel belongs to the page until the model has been chosen.
    if (!this.frame.matches(':focus')) return;
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE;
    const notches = (event.deltaY * (lines ? wheelLine : 1)) / wheelNotch;
    this.turn({ away: wheelZoom ** -notches });
  }

  private press(event: KeyboardEvent): void {
    const turn = keyTurns[event.key];
    if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.turn(turn);
  }
}
