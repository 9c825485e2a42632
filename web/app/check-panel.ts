import { faceLevels, mostFaces } from '../model/face-numbers.js';
import type { Settings } from '../model/options.js';
import type { Check } from './check.js';
import { bodyWords, lookWords, repairWords, triangleWords, wishWords } from './check-words.js';
import { make } from './dom.js';
import type { FacesField } from './faces-field.js';
import { MendCheck } from './mend-check.js';
import { NetsCheck } from './nets-check.js';
import { Panel } from './panel.js';
import { RepairList } from './repair-list.js';
import type { StudioPlace } from './place.js';
import type { OptionsForm } from './options-form.js';
import { SizeCheck } from './size-check.js';

/** Ends and steps of the slider: below is no shape, above no paper model. */
const slider = { least: 100, most: 3000, step: 50 } as const;

/** A list with its heading, which is there only with something in it. */
function fillList(list: HTMLElement, sentences: readonly string[]): void {
  const items = sentences.map((textContent) => make('li', { textContent }));
  list.querySelector('ul')?.replaceChildren(...items);
  list.hidden = items.length === 0;
}

export interface CheckListener {
  /** Leaves the model for the nets that were on the page before. */
  onBack: () => void;
  /** Keeps the nets of the file, or not. */
  onNets: (nets: Settings['nets']) => void;
}

/** What there is to decide and to know about a model before it is unfolded, beside its picture. */
export class CheckPanel extends Panel {
  private readonly card = this.find('#check', HTMLElement);
  private readonly why = this.find('#check-why', HTMLElement);
  private readonly levels = this.find('#check-levels', HTMLElement);
  private readonly slider = this.find('#check-faces', HTMLInputElement);
  private readonly number = this.find('#check-number', HTMLOutputElement);
  private readonly look = this.find('#check-look', HTMLElement);
  private readonly bound = this.find('#check-bound', HTMLElement);
  private readonly bodies = this.find('#check-bodies', HTMLElement);
  private readonly remaining = this.find('#check-remaining', HTMLElement);
  private readonly back = this.find('#check-back', HTMLButtonElement);
  private readonly triangles = this.find('#check-triangles', HTMLElement);
  private readonly size: SizeCheck;
  private readonly nets: NetsCheck;
  private readonly mending: MendCheck;
  private readonly fields: OptionsForm['mending'];
  private readonly faces: FacesField;
  private readonly repaired: RepairList;
  /** What is in the lists. */
  private listed: readonly unknown[] = [];

  constructor(
    place: StudioPlace,
    { faces, mending, size }: Pick<OptionsForm, 'faces' | 'mending' | 'size'>,
    { onBack, onNets }: CheckListener,
  ) {
    super(place);
    this.faces = faces;
    this.size = new SizeCheck(place, size);
    this.mending = new MendCheck(place, mending);
    this.repaired = new RepairList(place, mending);
    this.fields = mending;
    this.nets = new NetsCheck(place, onNets);
    this.slider.addEventListener('input', () => this.faces.set(this.slider.valueAsNumber));
    this.levels.addEventListener('click', ({ target }) => {
      if (!(target instanceof HTMLButtonElement)) return;
      this.faces.set(target.value === 'off' ? 'off' : Number(target.value));
    });
    this.back.addEventListener('click', onBack);
  }

  /** Shows the card, or puts it away. */
  set open(open: boolean) {
    this.card.hidden = !open;
  }

  /** Makes the card anew for a model. @param canLeave whether there are nets to go back to */
  begin(check: Check, canLeave: boolean): void {
    this.back.hidden = !canLeave;
    this.why.textContent = triangleWords(this.told, check.faces, check.proposal);
    this.levels.replaceChildren(...this.levelButtons(check));
    const most = Math.min(slider.most, Math.floor(check.faces / slider.step) * slider.step);
    Object.assign(this.slider, { min: slider.least, max: most, step: slider.step });
    this.find('#check-slider', HTMLElement).hidden = most <= slider.least;
    this.bound.hidden = check.isSearchable;
    this.bound.textContent = check.isSearchable
      ? ''
      : this.told.check.tooMany(check.faces, mostFaces);
    this.update(check);
  }

  /** Shows what the fields say now, and what the picture shows of it. */
  update(check: Check): void {
    const faces = this.faces.value;
    const wish = wishWords(this.told, faces, check.faces);
    // Nets of a file fit its own triangles only.
    this.triangles.hidden = check.faces <= faceLevels[0] || check.nets === 'file';
    this.nets.update(check);
    this.mending.update(check);
    this.list(check);
    for (const button of this.levels.querySelectorAll('button')) {
      button.setAttribute('aria-pressed', String(button.value === String(faces)));
    }
    const shown = Math.min(faces === 'off' ? check.faces : faces, check.faces);
    this.slider.value = String(shown);
    this.number.textContent = this.told.speech.large(shown);
    this.slider.setAttribute('aria-valuetext', wish);
    const seen = check.look ? check.look.model.faces.length / 3 : null;
    const words = lookWords(this.told, seen, check.working, wish);
    // Only what is new is spoken.
    if (this.look.textContent !== words) this.look.textContent = words;
    this.size.update(check.outline, check.nets);
  }

  /** Shows what the model is made of, what was repaired and what was not. */
  private list({ repairs, bodies, tinyBodies }: Check): void {
    const off = this.fields.value.repair;
    const listed = [repairs, ...off];
    if (listed.length === this.listed.length && listed.every((one, i) => one === this.listed[i]))
      return;
    this.listed = listed;
    this.bodies.textContent = bodyWords(this.told, bodies, tinyBodies);
    this.bodies.hidden = this.bodies.textContent === '';
    const { repaired, remaining } = repairWords(this.told, repairs, off);
    this.repaired.update(repaired);
    fillList(this.remaining, remaining);
  }

  private levelButtons(check: Check): HTMLButtonElement[] {
    const button = (value: Settings['faces'], words: string): HTMLButtonElement =>
      make('button', {
        type: 'button',
        className: 'button',
        value: String(value),
        textContent: words,
      });
    const { large } = this.told.speech;
    const levels = faceLevels.filter((level) => level < check.faces);
    const whole = button('off', this.told.check.asItIs(check.faces));
    whole.disabled = !check.isSearchable;
    if (whole.disabled) whole.setAttribute('aria-describedby', this.bound.id);
    return [...levels.map((level) => button(level, large(level))), whole];
  }
}
