import type { WindowPoint } from '../view/zoom.js';
import { isForField } from './dom.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What keeps the space bar for itself while it has the keyboard. */
const pressable = 'button, summary, a, input, select, [role=tab]';

const middleButton = 1;

function midpoint([one, two]: readonly [Touch, Touch]): WindowPoint {
  return { x: (one.clientX + two.clientX) / 2, y: (one.clientY + two.clientY) / 2 };
}

function distance([one, two]: readonly [Touch, Touch]): number {
  return Math.hypot(one.clientX - two.clientX, one.clientY - two.clientY);
}

/** Takes the mat along with a hand: the space bar and the mouse, the mouse's middle button, or two fingers. */
export class MatPan extends Panel {
  private readonly view = this.find('#mat-view', HTMLElement);
  private isSpaceDown = false;
  /** The pointer that pulls, and where the mat was when it began. */
  private grip: { pointer: number; x: number; y: number; left: number; top: number } | null = null;
  private swallowsClick = false;
  /** Pixels between two fingers. */
  private spread: number | null = null;

  /** @param onPinch is told how many times as large the sheets shall get, about a place of the window */
  constructor(
    place: StudioPlace,
    private readonly onPinch: (factor: number, at: WindowPoint) => void,
  ) {
    super(place);
    const { view } = this;
    // Before the tools on the sheets hear of it.
    view.addEventListener('pointerdown', (event) => this.press(event), { capture: true });
    view.addEventListener('pointermove', (event) => this.move(event), { capture: true });
    for (const type of ['pointerup', 'pointercancel'] as const) {
      view.addEventListener(type, (event) => this.release(event), { capture: true });
    }
    view.addEventListener('click', (event) => this.swallow(event), { capture: true });
    // The middle button would scroll by itself.
    view.addEventListener('mousedown', (event) => {
      if (event.button === middleButton) event.preventDefault();
    });
    view.addEventListener('touchmove', (event) => this.pinch(event), { passive: false });
    view.addEventListener('touchend', () => (this.spread = null));
    this.hearSpace();
  }

  private hearSpace(): void {
    const { ground, life } = this.place;
    const hear = (event: Event): void => {
      if (!(event instanceof KeyboardEvent) || event.key !== ' ') return;
      if (event.type === 'keyup') return this.holdSpace(false);
      const [target] = event.composedPath();
      const isTaken = target instanceof Element && target.closest(pressable) !== null;
      if (isTaken || isForField(event) || !this.view.matches(':hover')) return;
      event.preventDefault();
      this.holdSpace(true);
    };
    for (const type of ['keydown', 'keyup']) ground.addEventListener(type, hear, { signal: life });
  }

  private holdSpace(isDown: boolean): void {
    this.isSpaceDown = isDown;
    this.view.toggleAttribute('data-pannable', isDown);
  }

  private press(event: PointerEvent): void {
    this.swallowsClick = false;
    if (event.button !== middleButton && !(event.button === 0 && this.isSpaceDown)) return;
    event.preventDefault();
    event.stopPropagation();
    this.view.setPointerCapture(event.pointerId);
    this.view.toggleAttribute('data-panning', true);
    const { scrollLeft: left, scrollTop: top } = this.view;
    this.grip = { pointer: event.pointerId, x: event.clientX, y: event.clientY, left, top };
  }

  private move(event: PointerEvent): void {
    const { grip } = this;
    if (grip?.pointer !== event.pointerId) return;
    event.stopPropagation();
    // From where it began, so that no rounding adds up.
    const [left, top] = [grip.left + grip.x - event.clientX, grip.top + grip.y - event.clientY];
    this.view.scrollTo({ left, top, behavior: 'instant' });
  }

  private release(event: PointerEvent): void {
    if (this.grip?.pointer !== event.pointerId) return;
    event.stopPropagation();
    this.grip = null;
    this.swallowsClick = event.button === 0;
    this.view.toggleAttribute('data-panning', false);
  }

  private swallow(event: MouseEvent): void {
    if (!this.swallowsClick) return;
    this.swallowsClick = false;
    event.stopPropagation();
  }

  private pinch(event: TouchEvent): void {
    const [one, two] = event.touches;
    if (!one || !two) return;
    event.preventDefault();
    const now = distance([one, two]);
    if (this.spread !== null && this.spread > 0) {
      this.onPinch(now / this.spread, midpoint([one, two]));
    }
    this.spread = now;
  }
}
