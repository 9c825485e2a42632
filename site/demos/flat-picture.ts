/** A canvas of a demonstration that draws as the studio does. */
import { Painter, type PictureMessage } from '../../web/view/painter.js';

export class FlatPicture {
  private readonly painter: Painter;

  /** @param label what it shows, for who does not see it */
  constructor(place: HTMLElement, label: string) {
    const canvas = document.createElement('canvas');
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', label);
    place.append(canvas);
    this.painter = new Painter(canvas);
    new ResizeObserver(([entry]) => {
      const { width, height } = entry!.contentRect;
      this.painter.take({ type: 'size', width, height, density: devicePixelRatio });
    }).observe(canvas);
  }

  show(message: PictureMessage): void {
    this.painter.take(message);
  }
}
