import type { JobResult, Piece } from '../model/job.js';
import { lightEdges } from '../view/edge-lights.js';
import { signLocks } from '../view/lock-signs.js';
import { signPins } from '../view/pin-signs.js';
import { markSheet } from '../view/sheet-marks.js';
import type { LightsBySheet, LocksBySheet } from './edge-lighting.js';
import { MatView } from './mat-view.js';
import { nextFrame } from './next-frame.js';
import { Panel } from './panel.js';
import type { PinsBySheet } from './pin-places.js';
import type { StudioPlace } from './place.js';
import type { ResultWriter } from './result-writer.js';
import { drawSheet, keyOf, partsOf } from './sheet-figure.js';
import { placeOn, type SheetPlace } from './sheet-place.js';
import type { MarksBySheet } from './step-marks.js';

/** So many new sheets, as a piece changes that goes from one to another, come at once: the page must not move then. */
const fewSheets = 2;

/** Who hears of the pointer over the sheets. */
export interface SheetListener {
  /** The mouse is over a place of a sheet, or over none any more. */
  point(place: SheetPlace | null): void;
  /** A place was clicked, or something beside all sheets; `adds`: with a key that adds to what is chosen. */
  press(place: SheetPlace | null, adds: boolean): void;
  /** Something on the sheets is about to be looked at. */
  reveal(): void;
}

/** Pieces that stand out on the sheets, by their names. */
export interface PieceLights {
  chosen: string | null;
  pointed: string | null;
  /** It is on its way to another place, and fades where it lay. */
  lifted: string | null;
  /** It is being changed. */
  waiting: string | null;
}

const noLights: PieceLights = { chosen: null, pointed: null, lifted: null, waiting: null };

/** The sheets as they will be printed, with the parts in colour. */
export class SheetList extends Panel {
  private readonly list = this.find('#sheets', HTMLOListElement);
  private readonly mat: MatView;
  /** Sheets that were drawn, but are not on the page yet. */
  private coming: HTMLLIElement[] = [];
  private sheets: HTMLLIElement[] = [];
  /** By what they were made of. */
  private drawn = new Map<string, HTMLLIElement>();
  private pieces: readonly Piece[] = [];
  private marks: MarksBySheet = new Map();
  private lights: LightsBySheet = new Map();
  private locks: LocksBySheet = new Map();
  private pins: PinsBySheet = new Map();
  private pieceLights = noLights;
  private selected: readonly number[] = [];

  constructor(
    place: StudioPlace,
    private readonly listener: SheetListener,
  ) {
    super(place);
    this.mat = new MatView(place);
    this.list.addEventListener('click', (event) => {
      listener.press(this.placeOf(event), event.shiftKey || event.ctrlKey || event.metaKey);
    });
    this.list.addEventListener('pointermove', (event) => {
      // A finger that moves scrolls the page.
      if (event.pointerType === 'mouse') listener.point(this.placeOf(event));
    });
    this.list.addEventListener('pointerleave', () => listener.point(null));
  }

  /**
   * Draws all sheets with the exporter that also writes the files: screen and paper agree. Sheets that
   * are as those on the page are those on the page.
   */
  async draw(result: JobResult, writer: ResultWriter): Promise<HTMLLIElement[]> {
    const sources = await Promise.all(result.sheets.map((_, index) => writer.sheet(index)));
    const drawn = new Map<string, HTMLLIElement>();
    for (const [index, source] of sources.entries()) {
      const parts = partsOf(this.told, result, index, source);
      const key = keyOf(parts);
      const known = this.drawn.get(key);
      // A picture that takes long leaves the page time for others.
      if (!known && index > 0) await nextFrame();
      drawn.set(key, known ?? drawSheet(parts));
    }
    this.drawn = drawn;
    return [...drawn.values()];
  }

  /**
   * Puts the first of the sheets that were drawn in the place of those before, or all where few of them are new.
   *
   * @param whole puts all of them there, so that the page does not move
   */
  show(sheets: HTMLLIElement[], { pieces, sheets: papers }: JobResult, whole = false): void {
    this.lightPieces(noLights);
    const isOther = !whole && !sheets.some((sheet) => this.sheets.includes(sheet));
    const fresh = sheets.filter((sheet) => !this.sheets.includes(sheet));
    this.sheets = sheets;
    this.pieces = pieces;
    this.mark(new Map());
    this.light(new Map());
    const first = whole || fresh.length <= fewSheets ? sheets.length : 1;
    this.list.replaceChildren(...sheets.slice(0, first));
    this.coming = sheets.slice(first);
    this.list.setAttribute('aria-busy', 'true');
    this.select(this.selected);
    const largest = (side: 'width' | 'height'): number =>
      Math.max(...papers.map((paper) => paper[side]));
    const size = { width: largest('width'), height: largest('height') };
    this.mat.arrange({ count: sheets.length, ...size }, isOther);
  }

  /** Fits the sheets into their room, which they have from now on. */
  settle(): void {
    this.mat.keepFit();
  }

  /** Adds the other sheets, one in each frame: all at once they would keep the page for too long. */
  async complete(): Promise<void> {
    while (this.coming.length > 0) {
      await nextFrame();
      this.list.append(...this.coming.splice(0, 1));
    }
    this.list.removeAttribute('aria-busy');
  }

  /** Puts sheets of the same result that look otherwise in the place of those on the page. */
  replace(sheets: HTMLLIElement[]): void {
    this.sheets = sheets;
    this.coming = [];
    this.list.replaceChildren(...sheets);
    this.mark(this.marks);
    this.light(this.lights);
    this.lock(this.locks);
    this.pin(this.pins);
    this.lightPieces(this.pieceLights);
    this.select(this.selected);
  }

  /** Marks lines on the sheets, in place of those that were marked before. */
  mark(marks: MarksBySheet): void {
    this.marks = marks;
    this.onPictures((svg, index) => markSheet(svg, marks.get(index) ?? []));
  }

  /** Lights edges on the sheets, in place of those that were lit before. */
  light(lights: LightsBySheet): void {
    this.lights = lights;
    this.onPictures((svg, index) => lightEdges(svg, lights.get(index) ?? []));
  }

  /** Puts signs of locks on the sheets, in place of those before. */
  lock(locks: LocksBySheet): void {
    this.locks = locks;
    this.onPictures((svg, index) => signLocks(svg, locks.get(index) ?? []));
  }

  /** The same with signs of pins. */
  pin(pins: PinsBySheet): void {
    this.pins = pins;
    this.onPictures((svg, index) => signPins(svg, pins.get(index) ?? []));
  }

  /**
   * Scrolls the mat until the first lit edge of a sheet is in the middle of what is seen of it, as far as it goes.
   *
   * @returns how far it is below the upper end of the window then, in pixels
   */
  reveal(sheet: number): number {
    return this.centre(this.sheets[sheet]?.querySelector('[data-lights] > *'));
  }

  /** The same with a piece, by its name. */
  revealPiece(name: string): number {
    return this.centre(this.areaOf(name));
  }

  /** Lets pieces stand out, in place of those that did before. */
  lightPieces(lights: PieceLights): void {
    const before = this.pieceLights;
    this.pieceLights = lights;
    for (const kind of ['chosen', 'pointed', 'lifted', 'waiting'] as const) {
      if (before[kind] !== lights[kind]) {
        this.areaOf(before[kind])?.removeAttribute(`data-${kind}`);
      }
      this.areaOf(lights[kind])?.setAttribute(`data-${kind}`, '');
    }
  }

  /** The outline of a piece, by its name, as it is drawn on its sheet; null while that is not on the page. */
  outlineOf(name: string): string | null {
    return this.areaOf(name)?.getAttribute('d') ?? null;
  }

  /** The picture of a sheet; null for one to come. */
  pictureOf(sheet: number): SVGSVGElement | null {
    return this.sheets[sheet]?.querySelector('svg') ?? null;
  }

  /** Where the pointer is on the nearest sheet, on it or beside it. */
  nearestPlace(event: MouseEvent): SheetPlace | null {
    const away = (sheet: HTMLLIElement): number => {
      const { left, right, top, bottom } = sheet.getBoundingClientRect();
      const across = Math.max(left - event.clientX, 0, event.clientX - right);
      return Math.hypot(across, Math.max(top - event.clientY, 0, event.clientY - bottom));
    };
    const distances = this.sheets.map(away);
    const sheet = distances.indexOf(Math.min(...distances));
    const svg = this.pictureOf(sheet);
    return svg && placeOn(svg, sheet, event);
  }

  /** Lets parts stand out from all others, unless there are none. */
  select(parts: readonly number[]): void {
    this.selected = parts;
    this.list.toggleAttribute('data-selecting', parts.length > 0);
    const chosen = this.pieces.filter(({ part }) => parts.includes(part));
    const letters = new Set(chosen.map(({ name }) => name));
    for (const sheet of this.sheets) {
      for (const area of sheet.querySelectorAll<SVGElement>('[data-area]')) {
        area.toggleAttribute('data-selected', letters.has(area.dataset['area'] ?? ''));
      }
    }
  }

  private onPictures(draw: (svg: SVGSVGElement, sheet: number) => void): void {
    this.sheets.forEach((sheet, index) => {
      const svg = sheet.querySelector('svg');
      if (svg) draw(svg, index);
    });
  }

  private areaOf(name: string | null): SVGElement | null {
    const sheet = this.pieces.find((piece) => piece.name === name)?.sheet;
    const areas =
      sheet === undefined
        ? undefined
        : this.sheets[sheet]?.querySelectorAll<SVGElement>('[data-area]');
    return [...(areas ?? [])].find(({ dataset }) => dataset['area'] === name) ?? null;
  }

  private centre(element: Element | null | undefined): number {
    if (!element) return 0;
    this.listener.reveal();
    element.scrollIntoView({ block: 'center', inline: 'center' });
    const { top, height } = element.getBoundingClientRect();
    return top + height / 2;
  }

  private placeOf(event: MouseEvent): SheetPlace | null {
    const { target } = event;
    const sheet = this.sheets.findIndex((item) => target instanceof Node && item.contains(target));
    const svg = target instanceof Element ? target.closest('svg') : null;
    return svg && sheet >= 0 ? placeOn(svg, sheet, event) : null;
  }
}
