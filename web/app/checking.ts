import type { Settings } from '../model/options.js';
import { writtenRepair } from '../model/repair-steps.js';
import type { Inspection } from '../api/inspect.js';
import type { Check } from './check.js';
import { CheckPanel } from './check-panel.js';
import { nextFrame } from './next-frame.js';
import type { OptionsForm } from './options-form.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { Wishes } from './quick-looks.js';
import type { Store } from './store.js';
import type { Workshop } from './workshop.js';

/** Ms of rest after which a change of the slider is looked at: while it moves, each look would end the one before. */
const rest = 120;

/** Lets a person look at the chosen model before it is unfolded: the picture and the card beside it. */
export class Checking extends Panel {
  private readonly panel: CheckPanel;
  private readonly room = this.find('#workshop', HTMLElement);
  private readonly again = this.find('#check-again', HTMLButtonElement);
  /** Those that the card and the picture show. */
  private check: Check | null = null;
  private look: Inspection | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly form: OptionsForm,
    private readonly workshop: Workshop,
  ) {
    super(place);
    const show = (isShown: boolean) => () => store.showCheck(isShown);
    this.panel = new CheckPanel(place, form, {
      onBack: show(false),
      onNets: (nets) => this.choose(nets),
    });
    this.again.addEventListener('click', show(true));
    form.onChange(() => {
      if (!this.check) return;
      this.panel.update(this.check);
      this.followForm();
    });
    for (const topic of ['check', 'work', 'scene'] as const) store.on(topic, () => this.follow());
    place.life.addEventListener('abort', () => clearTimeout(this.timer));
  }

  /** What a person has asked for, whatever model is chosen. */
  get ownWishes(): Wishes {
    return { faces: this.form.faces.own, up: this.form.size.upwards };
  }

  /** Sets the number of triangles that is proposed for a model, unless a person has asked for another one. */
  propose({ proposal }: Check): void {
    this.form.faces.forget();
    this.form.mending.forget();
    if (proposal !== null && this.form.faces.value === 'off') this.form.faces.set(proposal);
  }

  /** Brings the card in front of the person, once it has its place. */
  async reveal(): Promise<void> {
    await nextFrame();
    const { top } = this.room.getBoundingClientRect();
    // On a phone it is below the form.
    if (top > innerHeight / 2) this.room.scrollIntoView({ block: 'start' });
  }

  /** Nets of a file fit the model as it is. */
  private choose(nets: Settings['nets']): void {
    const { check } = this.store;
    if (!check) return;
    check.choose(nets);
    if (nets === 'file') this.form.faces.set('off');
    else this.propose(check);
  }

  private follow(): void {
    const { check, scene, work } = this.store;
    const isOpen = scene === 'check' && check !== null;
    this.panel.open = isOpen;
    this.workshop.checking = isOpen;
    this.again.hidden = isOpen || !check?.hasToDecide;
    this.again.disabled = work !== 'idle';
    if (!isOpen) {
      this.check = this.look = null;
      return;
    }
    const isNew = check !== this.check;
    this.check = check;
    if (isNew) this.panel.begin(check, this.store.run !== null);
    else this.panel.update(check);
    if (check.look !== this.look) this.draw(check, !isNew);
    this.followForm();
  }

  private draw(check: Check, isSame: boolean): void {
    this.look = check.look;
    if (!check.look) return;
    const { model } = check.look;
    // What lies inside is to be seen, and that it is gone.
    const isGlass = check.innerBodies > 0;
    this.workshop.preview({ name: check.name, ...model, labels: check.tinyFaces, isSame, isGlass });
  }

  /** A number that was asked for is seen a moment later. */
  private followForm(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      const { faces, mending, size } = this.form;
      const { repair, 'fill-holes': fillHoles, ...bodies } = mending.value;
      const mended = { repair: writtenRepair(repair), fillHoles, ...bodies };
      const aspect = { faces: faces.value, up: size.upwards, ...mended };
      void this.store.preview(aspect);
    }, rest);
  }
}
