import type { Settings } from '../model/options.js';
import type { Check } from './check.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

type Nets = Settings['nets'];

/** Asks whether the nets that a file brings along are kept. */
export class NetsCheck extends Panel {
  private readonly box = this.find('#check-nets', HTMLElement);
  private readonly words = this.find('#check-nets-words', HTMLElement);

  constructor(place: StudioPlace, onChoice: (nets: Nets) => void) {
    super(place);
    this.box.addEventListener('click', ({ target }) => {
      if (target instanceof HTMLButtonElement) onChoice(target.value === 'file' ? 'file' : 'new');
    });
  }

  update({ fileNets, nets }: Check): void {
    this.box.hidden = fileNets === 0;
    for (const button of this.box.querySelectorAll('button')) {
      button.setAttribute('aria-pressed', String(button.value === nets));
    }
    const { netsKept, netsOffered } = this.told.check;
    const words = nets === 'file' ? netsKept : netsOffered(fileNets);
    this.words.textContent = fileNets === 0 ? '' : words;
  }
}
