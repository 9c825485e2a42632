import { drawRuler } from '../view/ruler-picture.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Rulers along the mat, in mm from the upper left corner of the sheet in the middle. */
export class MatRulers extends Panel {
  private readonly view = this.find('#mat-view', HTMLElement);
  private readonly across = this.find('#ruler-across', SVGSVGElement);
  private readonly down = this.find('#ruler-down', SVGSVGElement);
  private pixelsPerMm = 0;
  private isAsked = false;

  /** @param sheet that is measured from */
  constructor(
    place: StudioPlace,
    private readonly sheet: () => SVGSVGElement | null,
  ) {
    super(place);
    this.view.addEventListener('scroll', () => this.update(), { passive: true });
  }

  /** Takes another size of the sheets: of the widest, in mm and in pixels. */
  take(width: number, pixels: number): void {
    this.pixelsPerMm = pixels / width;
    this.update();
  }

  /** Draws the rulers with the next frame. */
  update(): void {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => {
      this.isAsked = false;
      if (!this.place.life.aborted) this.draw();
    });
  }

  private draw(): void {
    const sheet = this.sheet()?.getBoundingClientRect();
    const { left, top, width, height } = this.view.getBoundingClientRect();
    const { pixelsPerMm } = this;
    if (!sheet || pixelsPerMm <= 0 || width === 0) return;
    drawRuler(this.across, {
      zero: sheet.left - left,
      pixelsPerMm,
      length: width,
      isUpright: false,
    });
    drawRuler(this.down, { zero: sheet.top - top, pixelsPerMm, length: height, isUpright: true });
  }
}
