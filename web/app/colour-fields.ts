import type { FlapBleed, PrintOptions } from '../model/print-options.js';
import { defaultPrint, printsTexture } from '../model/print-options.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What faces are printed in, in one choice. */
type Choice = 'model' | 'part' | 'none';

type Wish = Pick<PrintOptions, 'texture' | 'colour'>;

const bleeds: readonly FlapBleed[] = ['none', 'half', 'whole'];

/** The fields for colours on paper, and for light and shade. */
export class ColourFields extends Panel {
  private readonly colours = this.find('#print-colours', HTMLSelectElement);
  private readonly ofModel = this.find('#print-colours-model', HTMLOptionElement);
  private readonly shading = this.find('#print-shading', HTMLInputElement);
  private readonly bleed = this.find('#print-flap-bleed', HTMLSelectElement);
  private readonly hint = this.find('#print-colours-hint', HTMLElement);
  /** What the document says, for as long as the choice is the one that shows it. */
  private wish: Wish = defaultPrint;
  private hasLooks = false;

  constructor(place: StudioPlace) {
    super(place);
    this.fill(defaultPrint, false);
  }

  /** @param hasLooks whether the model has colours or pictures */
  fill({ texture, colour, flapBleed, shading }: PrintOptions, hasLooks: boolean): void {
    this.wish = { texture, colour };
    this.hasLooks = hasLooks;
    this.ofModel.disabled = !hasLooks;
    this.colours.value = this.choiceOf(this.wish);
    this.bleed.value = flapBleed;
    this.shading.checked = shading;
  }

  read(): Wish & Pick<PrintOptions, 'flapBleed' | 'shading'> {
    const flapBleed = bleeds.find((name) => name === this.bleed.value) ?? defaultPrint.flapBleed;
    const others = { flapBleed, shading: this.shading.checked };
    const choice = this.colours.value;
    if (choice === this.choiceOf(this.wish)) return { ...this.wish, ...others };
    // A later model with colours shall show them, unless they were switched off.
    const texture = choice === 'none' && this.hasLooks ? 'off' : 'auto';
    return { texture, colour: choice === 'part' ? 'part' : 'none', ...others };
  }

  /** Says what colours come to with the other options. */
  explain(options: PrintOptions): void {
    const takesColours = printsTexture({ ...options, texture: 'on' });
    this.colours.disabled = !takesColours;
    this.shading.disabled = !takesColours;
    const isPlain = this.colours.value === 'none' && !this.shading.checked;
    this.bleed.disabled = !takesColours || isPlain;
    this.hint.textContent = this.wordsFor(options, takesColours);
  }

  private choiceOf(wish: Wish): Choice {
    return this.hasLooks && printsTexture({ ...defaultPrint, ...wish }) ? 'model' : wish.colour;
  }

  private wordsFor({ machine }: PrintOptions, takesColours: boolean): string {
    const { noColours, noLooks, noPartColours } = this.told.printing;
    if (!takesColours) return noColours;
    if (machine === 'silhouette' && this.colours.value === 'part') {
      return noPartColours;
    }
    return this.hasLooks ? '' : noLooks;
  }
}
