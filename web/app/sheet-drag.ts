import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { SheetPlace } from './sheet-place.js';

/** Pixels that a hand may tremble between press and release. */
const tremble = 5;

/** Degrees of a notch of the wheel, and of the key R; with Shift the other way round. */
const turns = { wheel: 15, key: 90 };

/** How near to the end of what is seen of the mat it begins to move, and how far it does in a frame; pixels. */
const scrolling = { reach: 28, step: 12 };

/** Which way to go on from a place between two ends: -1, 1, or 0 where it is far from both. */
function wayFrom(at: number, from: number, to: number): -1 | 0 | 1 {
  if (at < from + scrolling.reach) return -1;
  return at > to - scrolling.reach ? 1 : 0;
}

export interface SheetDragListener {
  /** Whether what lies at a place can be dragged from there. */
  isLiftable(place: SheetPlace, isFinger: boolean): boolean;
  /** Takes it up. */
  lift(place: SheetPlace): void;
  follow(place: SheetPlace): void;
  turn(degrees: number): void;
  drop(): void;
  cancel(): void;
}

/** Drags over the sheets with mouse, pen or finger. Nothing is selected by it, and no click comes of it. */
export class SheetDrag extends Panel {
  private readonly list = this.find('#sheets', HTMLOListElement);
  private readonly view = this.find('#mat-view', HTMLElement);
  /** A press on something that can be dragged, which may still become a drag. */
  private pressed: { event: PointerEvent; place: SheetPlace } | null = null;
  /** The pointer that drags, where it was last. */
  private dragging: PointerEvent | null = null;
  /** Whether the click to come is the end of a drag. */
  private swallowsClick = false;

  /** @param placeOf the place on the nearest sheet, on it or beside it */
  constructor(
    place: StudioPlace,
    private readonly placeOf: (event: MouseEvent) => SheetPlace | null,
    private readonly listener: SheetDragListener,
  ) {
    super(place);
    const { list } = this;
    list.addEventListener('pointerdown', (event) => this.press(event));
    list.addEventListener('pointermove', (event) => this.move(event));
    list.addEventListener('pointerup', () => this.end('drop'));
    list.addEventListener('pointercancel', () => this.end('cancel'));
    list.addEventListener('click', (event) => this.swallow(event), { capture: true });
    list.addEventListener('wheel', (event) => this.roll(event), { passive: false });
    // Before it is clear whether a finger drags or scrolls the page has to stand still for it.
    const hold = (event: TouchEvent): void => {
      if (this.pressed || this.dragging) event.preventDefault();
    };
    list.addEventListener('touchmove', hold, { passive: false });
    const hear = (event: Event): void => {
      if (event instanceof KeyboardEvent) this.key(event);
    };
    // Before others hear of it: the keys are the drag's own.
    place.ground.addEventListener('keydown', hear, { capture: true, signal: place.life });
  }

  private press(event: PointerEvent): void {
    this.swallowsClick = false;
    const place = event.button === 0 && event.isPrimary ? this.placeOf(event) : null;
    const isFinger = event.pointerType === 'touch';
    this.pressed = place && this.listener.isLiftable(place, isFinger) ? { event, place } : null;
  }

  private move(event: PointerEvent): void {
    if (this.dragging?.pointerId === event.pointerId) {
      this.dragging = event;
      this.follow();
      return;
    }
    const { pressed } = this;
    if (pressed?.event.pointerId !== event.pointerId) return;
    const { clientX, clientY } = pressed.event;
    if (Math.hypot(event.clientX - clientX, event.clientY - clientY) <= tremble) return;
    this.pressed = null;
    this.listener.lift(pressed.place);
    this.list.setPointerCapture(event.pointerId);
    this.list.toggleAttribute('data-dragging', true);
    this.dragging = event;
    this.follow();
    requestAnimationFrame(this.scroll);
  }

  private follow(): void {
    const place = this.dragging && this.placeOf(this.dragging);
    if (place) this.listener.follow(place);
  }

  private end(how: 'drop' | 'cancel'): void {
    this.pressed = null;
    const { dragging } = this;
    if (!dragging) return;
    this.dragging = null;
    this.swallowsClick = true;
    this.list.releasePointerCapture(dragging.pointerId);
    this.list.toggleAttribute('data-dragging', false);
    this.listener[how]();
  }

  private swallow(event: MouseEvent): void {
    if (!this.swallowsClick) return;
    this.swallowsClick = false;
    event.stopImmediatePropagation();
  }

  private roll(event: WheelEvent): void {
    if (!this.dragging) return;
    event.preventDefault();
    this.turn(event.deltaY > 0 ? -turns.wheel : turns.wheel);
  }

  private key(event: KeyboardEvent): void {
    if (!this.dragging) return;
    if (event.key === 'Escape') this.end('cancel');
    else if (event.key.toLowerCase() === 'r') this.turn(event.shiftKey ? -turns.key : turns.key);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private turn(degrees: number): void {
    this.listener.turn(degrees);
    this.follow();
  }

  /** Who drags to the end of the mat, or of the window, wants to go on to what lies beyond it. */
  private readonly scroll = (): void => {
    if (!this.dragging || this.place.life.aborted) return;
    requestAnimationFrame(this.scroll);
    const { clientX, clientY } = this.dragging;
    const { left, right, top, bottom } = this.view.getBoundingClientRect();
    const across = wayFrom(clientX, Math.max(left, 0), Math.min(right, innerWidth));
    const down = wayFrom(clientY, Math.max(top, 0), Math.min(bottom, innerHeight));
    if (across === 0 && down === 0) return;
    const [x, y] = [across * scrolling.step, down * scrolling.step];
    const isOwn = this.view.scrollHeight > this.view.clientHeight;
    this.view.scrollBy(x, isOwn ? y : 0);
    if (!isOwn) scrollBy(0, y);
    this.follow();
  };
}
