import {
  allInView,
  clampedWidth,
  oneInView,
  scrollTo,
  shareAt,
  wheelFactor,
  type Arrangement,
  type WindowPoint,
} from '../view/zoom.js';
import { MatPan } from './mat-pan.js';
import { MatRulers } from './mat-rulers.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Pixels: between sheets, and of the caption below each, as `mat.css` has them. */
const gaps = { between: 24, caption: 28 };

/** Pixels around all sheets on a mat that scrolls by itself, as `mat.css` has them. */
const air = 16;

/** What the sheets are kept at while the window, or the room for them, changes. */
type Fit = 'one' | 'all' | null;

/** Where the sheets lie: how large they are seen, and which part of the mat. */
export class MatView extends Panel {
  private readonly view = this.find('#mat-view', HTMLElement);
  private readonly list = this.find('#sheets', HTMLOListElement);
  private readonly zoom = this.find('#zoom', HTMLInputElement);
  private readonly rulers: MatRulers;
  private sheets: Arrangement | null = null;
  private fit: Fit = 'one';
  private width = this.zoom.valueAsNumber;
  /** Set anew only for another model: sheets that are looked at shall stay where they are. */
  private columns = 0;

  constructor(place: StudioPlace) {
    super(place);
    this.rulers = new MatRulers(place, () => this.middleSheet());
    new MatPan(place, (factor, at) => this.zoomTo(factor * this.width, at));
    this.zoom.addEventListener('input', () => this.zoomTo(this.zoom.valueAsNumber, this.middle));
    this.find('#mat-fit', HTMLButtonElement).addEventListener('click', () => this.showOne());
    this.find('#mat-all', HTMLButtonElement).addEventListener('click', () => this.showAll());
    this.view.addEventListener('wheel', (event) => this.roll(event), { passive: false });
    this.list.addEventListener('keydown', (event) => this.key(event));
    const follow = (): void => {
      this.keepFit();
      this.rulers.update();
    };
    const observer = new ResizeObserver(() => {
      // Where the page scrolls, the sheets make the view as high as it is: within the observer's turn that is an error.
      if (this.isOwn) follow();
      else requestAnimationFrame(follow);
    });
    observer.observe(this.view);
    place.life.addEventListener('abort', () => observer.disconnect());
  }

  /**
   * Makes room for sheets.
   *
   * @param isOther they are those of another model, or of another search: they are arranged and seen afresh
   */
  arrange(sheets: Arrangement, isOther: boolean): void {
    this.sheets = sheets;
    if (isOther) {
      this.fit = 'one';
      this.columns = 0;
      this.view.scrollTo(0, 0);
    }
    this.keepFit();
    this.rulers.take(sheets.width, this.width);
  }

  /** Whether the mat is scrolled by itself, and not with the page; the style knows. */
  private get isOwn(): boolean {
    return this.says('--own-scroll');
  }

  private says(property: string): boolean {
    return getComputedStyle(this.view).getPropertyValue(property).trim() === '1';
  }

  private get room(): { width: number; height: number; gaps: typeof gaps } {
    const { clientWidth, clientHeight } = this.view;
    const around = this.isOwn ? 2 * air : 0;
    return { width: clientWidth - around, height: clientHeight - around, gaps };
  }

  /** What is seen of the mat, in the window. */
  private get middle(): WindowPoint {
    const { left, top, width, height } = this.view.getBoundingClientRect();
    return { x: left + width / 2, y: top + height / 2 };
  }

  /** Fits the sheets into their room; to be called when they come to be seen, so that they are never seen otherwise. */
  keepFit(): void {
    const { sheets, room } = this;
    if (!sheets || room.width <= 0) return;
    if (this.columns === 0) this.divide(this.isOwn ? allInView(sheets, room).columns : 1);
    if (this.fit === 'all' && this.isOwn) this.resize(allInView(sheets, room).width);
    else if (this.fit !== null) {
      this.resize(oneInView(sheets, { ...room, height: this.isOwn ? room.height : null }));
    }
  }

  private divide(columns: number): void {
    this.columns = columns;
    this.list.style.setProperty('--columns', String(columns));
  }

  private resize(width: number): void {
    this.width = width;
    this.list.style.setProperty('--sheet-width', `${width}px`);
    this.list.toggleAttribute('data-fitted', this.fit !== null);
    this.zoom.value = String(width);
    if (this.sheets) this.rulers.take(this.sheets.width, width);
  }

  /** Shows the sheet in the middle as a whole. */
  private showOne(): void {
    const sheet = this.middleSheet();
    this.fit = 'one';
    this.keepFit();
    sheet?.closest('li')?.scrollIntoView({ block: 'center', inline: 'center' });
  }

  private showAll(): void {
    this.fit = 'all';
    this.columns = 0;
    this.keepFit();
    this.view.scrollTo(0, 0);
  }

  /** Changes the size; what lies at a place of the window stays there, as far as the mat goes. */
  private zoomTo(width: number, at: WindowPoint): void {
    const sheet = this.nearestSheet(at);
    const share = sheet && shareAt(sheet.getBoundingClientRect(), at);
    this.fit = null;
    this.resize(clampedWidth(width));
    if (!sheet || !share) return;
    const { x, y } = scrollTo(sheet.getBoundingClientRect(), share, at);
    this.view.scrollBy({ left: x, top: y, behavior: 'instant' });
  }

  private roll(event: WheelEvent): void {
    // A piece in a hand is turned.
    if (event.defaultPrevented) return;
    const isPlain = !event.shiftKey && event.deltaX === 0 && this.says('--wheel-zooms');
    if (!event.ctrlKey && !event.metaKey && !isPlain) return;
    event.preventDefault();
    this.zoomTo(wheelFactor(event) * this.width, { x: event.clientX, y: event.clientY });
  }

  /** Plus and minus change the size, 0 shows a whole sheet. */
  private key({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): void {
    if (ctrlKey || metaKey || altKey) return;
    if (key === '+' || key === '=') this.zoomTo(1.25 * this.width, this.middle);
    else if (key === '-') this.zoomTo(this.width / 1.25, this.middle);
    else if (key === '0') this.showOne();
  }

  private middleSheet(): SVGSVGElement | null {
    return this.nearestSheet(this.middle);
  }

  private nearestSheet({ x, y }: WindowPoint): SVGSVGElement | null {
    const pictures = [...this.list.querySelectorAll<SVGSVGElement>('.sheet svg')];
    const away = (svg: SVGSVGElement): number => {
      const { left, right, top, bottom } = svg.getBoundingClientRect();
      return Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));
    };
    const distances = pictures.map(away);
    return pictures[distances.indexOf(Math.min(...distances))] ?? null;
  }
}
