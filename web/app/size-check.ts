import { extentsOf } from '../model/bounds.js';
import type { Settings } from '../model/options.js';
import { pencil, pencilPath, silhouetteOf } from '../view/silhouette.js';
import type { Inspection } from '../api/inspect.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { SizeFields, Wish } from './size-fields.js';

/** Sides of a bounding box by the kinds of size that ask for them. */
const sideOf: Readonly<Partial<Record<Wish['kind'], number>>> = { width: 0, height: 1, depth: 2 };

/** Between model and pencil, and around both, in mm at the size of the pencil. */
const gap = 15;

/** How many mm a unit of the model becomes; null if only the nets decide that. */
function scaleFor({ kind, amount }: Wish, sides: readonly number[]): number | null {
  const side = sideOf[kind];
  if (side === undefined || amount === null) return null;
  return sides[side]! > 0 ? amount / sides[side]! : null;
}

/** Draws the model at its wished size beside a pencil, and offers sizes. */
export class SizeCheck extends Panel {
  private readonly picture = this.find('#check-drawing', SVGSVGElement);
  private readonly shape = this.find('#check-shape', SVGPathElement);
  private readonly pencil = this.find('#check-pencil', SVGPathElement);
  private readonly words = this.find('#check-size-words', HTMLElement);
  private readonly buttons = this.find('#check-heights', HTMLElement);
  /** What is drawn, as drawing thousands of triangles for nothing is slow. */
  private drawn = '';
  private drawnLook: Inspection | null = null;

  constructor(
    place: StudioPlace,
    private readonly size: SizeFields,
  ) {
    super(place);
    this.pencil.setAttribute('d', pencilPath());
    this.buttons.addEventListener('click', ({ target }) => {
      if (!(target instanceof HTMLButtonElement)) return;
      this.size.choose(target.value === 'fit' ? 'fit' : Number(target.value));
    });
  }

  /**
   * @param look null while there is none that is quick to draw
   * @param nets whose they are: those of the file have a size of their own
   */
  update(look: Inspection | null, nets: Settings['nets']): void {
    const { wish } = this.size;
    for (const button of this.buttons.querySelectorAll('button')) {
      const height = wish.kind === 'height' ? String(wish.amount) : wish.kind;
      button.setAttribute('aria-pressed', String(button.value === height));
    }
    const key = `${wish.kind} ${wish.amount} ${nets}`;
    if (key === this.drawn && look === this.drawnLook) return;
    [this.drawn, this.drawnLook] = [key, look];
    const sides = look ? extentsOf(look.model.vertices) : [0, 0, 0];
    const scale = scaleFor(wish, sides);
    if (look && scale !== null) this.draw(look, scale);
    else this.drawNothing(wish, nets);
  }

  private draw({ model }: Inspection, scale: number): void {
    const { path, width, height } = silhouetteOf(model.vertices, model.faces, scale);
    this.shape.setAttribute('d', path);
    const right = width + gap;
    this.pencil.setAttribute('transform', `translate(${right} 0)`);
    const tallest = Math.max(height, pencil.length);
    const box = [-gap, -tallest - gap, right + pencil.width + 2 * gap, tallest + 2 * gap];
    this.picture.setAttribute('viewBox', box.join(' '));
    const [x, y, z] = extentsOf(model.vertices);
    this.words.textContent = this.told.check.size({
      width: scale * x,
      height: scale * y,
      depth: scale * z,
      pencil: pencil.length,
    });
    this.picture.removeAttribute('hidden');
  }

  private drawNothing({ kind }: Wish, nets: Settings['nets']): void {
    this.picture.setAttribute('hidden', '');
    const { chooseHeight, fits } = this.told.check;
    this.words.textContent = `${fits[kind === 'fit' ? nets : 'other']} ${chooseHeight}`;
  }
}
