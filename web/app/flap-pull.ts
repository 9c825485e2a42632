import { gripOf, pulledHeight, withHeight, type SheetFlap } from '../model/sheet-flaps.js';
import { drawGhost, type Ghost } from '../view/piece-ghost.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { SheetDrag } from './sheet-drag.js';
import type { SheetList } from './sheet-list.js';
import type { SheetPlace } from './sheet-place.js';
import type { Store } from './store.js';

/** How near to its grip a flap is taken hold of, in pixels. */
const reach = { mouse: 9, finger: 22 };

const atRest = { about: [0, 0], degrees: 0, by: [0, 0] } as const;

export interface FlapPullListener {
  /** So high the flap would be now, mm; null: it is as it was. */
  preview(height: number | null): void;
  /** The flap shall be so high, mm. */
  pull(height: number): void;
}

/** The flap of the edge that is chosen, whose top a hand pulls to another height. */
export class FlapPull extends Panel {
  private readonly layer = this.find('#flap-ghost', SVGSVGElement);
  private flap: SheetFlap | null = null;
  /** Of the flap in the hand, mm. */
  private height: number | null = null;

  constructor(
    place: StudioPlace,
    store: Store,
    private readonly sheets: SheetList,
    private readonly listener: FlapPullListener,
  ) {
    super(place);
    new SheetDrag(place, (event) => sheets.nearestPlace(event), {
      isLiftable: (at, isFinger) => !store.busy && this.holds(at, isFinger),
      lift: (at) => this.follow(at),
      follow: (at) => this.follow(at),
      turn: () => {},
      drop: () => {
        const { height } = this;
        this.letGo();
        if (height !== null) listener.pull(height);
      },
      cancel: () => this.letGo(),
    });
  }

  /** Takes another flap; null: none. */
  offer(flap: SheetFlap | null): void {
    this.flap = flap;
    this.height = null;
    this.draw();
  }

  /** Whether a press at a place takes the flap. */
  holds({ sheet, point, mmPerPixel }: SheetPlace, isFinger = false): boolean {
    if (this.flap?.sheet !== sheet) return false;
    const [x, y] = gripOf(this.flap);
    const away = Math.hypot(point[0] - x, point[1] - y);
    return away <= mmPerPixel * (isFinger ? reach.finger : reach.mouse);
  }

  private follow({ sheet, point }: SheetPlace): void {
    const { flap } = this;
    if (flap?.sheet !== sheet) return;
    this.height = pulledHeight(flap, point);
    this.draw();
    this.listener.preview(this.height);
  }

  private letGo(): void {
    this.height = null;
    this.draw();
    this.listener.preview(null);
  }

  private draw(): void {
    drawGhost(this.layer, this.ghost);
  }

  private get ghost(): Ghost | null {
    const { flap, height, sheets } = this;
    const sheet = flap && height !== null ? sheets.pictureOf(flap.sheet) : null;
    if (!flap || height === null || !sheet) return null;
    const top = sheet.viewBox.baseVal.height;
    const corners = withHeight(flap, height).map(([x, y]) => `${x} ${top - y}`);
    return { outline: `M${corners.join('L')}Z`, motion: atRest, sheet, state: 'free' };
  }
}
