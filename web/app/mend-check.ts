import type { Check } from './check.js';
import type { Mending, MendFields } from './mend-fields.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** Shows which of some buttons says what is chosen. */
function press(box: HTMLElement, chosen: string): void {
  for (const button of box.querySelectorAll('button')) {
    button.setAttribute('aria-pressed', String(button.value === chosen));
  }
}

/** Asks what to do about holes and about bodies inside others or through each other, where a model has some. */
export class MendCheck extends Panel {
  private readonly holes = this.find('#check-holes', HTMLElement);
  private readonly holesWords = this.find('#check-holes-words', HTMLElement);
  private readonly small = this.find('#check-holes-small', HTMLButtonElement);
  private readonly inside = this.find('#check-inside', HTMLElement);
  private readonly insideWords = this.find('#check-inside-words', HTMLElement);
  private readonly crossing = this.find('#check-crossing', HTMLElement);

  constructor(
    place: StudioPlace,
    private readonly fields: MendFields,
  ) {
    super(place);
    this.follow(this.holes, (value) => ({
      'fill-holes': value === 'off' || value === 'all' ? value : Number(value),
    }));
    this.follow(this.inside, (value) => ({ inside: value === 'drop' ? 'drop' : 'keep' }));
    this.follow(this.crossing, (value) => ({ crossing: value === 'unite' ? 'unite' : 'keep' }));
  }

  /** Shows what there is to mend, and what the fields say about it. */
  update({ holes, innerBodies, canUnite }: Check): void {
    const mending = this.fields.value;
    this.holes.hidden = holes === null;
    this.holesWords.textContent = holes === null ? '' : this.told.check.holes(holes);
    // Where all are small, or none is, that is the same as all or nothing.
    this.small.hidden = holes === null || holes.small === 0 || holes.small === holes.count;
    this.small.value = String(holes?.smallPercent ?? '');
    press(this.holes, String(mending['fill-holes']));
    this.inside.hidden = innerBodies === 0;
    this.insideWords.textContent = innerBodies === 0 ? '' : this.told.check.inside(innerBodies);
    press(this.inside, mending.inside);
    this.crossing.hidden = !canUnite;
    press(this.crossing, mending.crossing);
  }

  private follow(box: HTMLElement, mending: (value: string) => Partial<Mending>): void {
    box.addEventListener('click', ({ target }) => {
      if (target instanceof HTMLButtonElement) this.fields.set(mending(target.value));
    });
  }
}
