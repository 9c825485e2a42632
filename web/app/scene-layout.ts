import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { Scene } from './scene.js';

/** Which of the two pages of a studio is there: that on which a model is chosen, or the bench for one. */
export type Page = 'start' | 'bench';

/** Arranges the page for what fills it. */
export class SceneLayout extends Panel {
  private readonly studio = this.find('.studio', HTMLElement);
  private readonly welcome = this.find('#welcome', HTMLElement);
  private readonly side = this.find('#result-side', HTMLElement);
  private readonly inspector = this.find('#inspector', HTMLElement);
  private readonly progress = this.find('#progress', HTMLElement);
  private readonly form = this.find('#controls', HTMLFormElement);
  private readonly settings = this.find('#settings', HTMLDetailsElement);
  private readonly places: Readonly<Record<Page, HTMLElement>> = {
    start: this.find('#start-form', HTMLElement),
    bench: this.find('#bench-form', HTMLElement),
  };
  private scene: Scene = 'welcome';

  /** @param onPage is told which page is there */
  constructor(
    place: StudioPlace,
    private readonly onPage: (page: Page) => void,
  ) {
    super(place);
    // A field that makes no sense cannot be pointed at while it is folded away.
    this.settings.addEventListener('invalid', () => (this.settings.open = true), true);
  }

  show(scene: Scene): void {
    if (scene === this.scene) return;
    const isFirst = this.scene === 'welcome';
    this.scene = scene;
    const page: Page = scene === 'welcome' ? 'start' : 'bench';
    this.studio.dataset['scene'] = scene;
    this.welcome.hidden = scene !== 'welcome';
    this.side.hidden = scene !== 'result';
    this.putForm(page);
    // Once there is a model there is something to set.
    if (isFirst) this.settings.open = true;
    // What came out stands at its top, and the bench begins at its own.
    if (scene === 'result') this.inspector.scrollTop = 0;
    if (isFirst && this.studio.getBoundingClientRect().top < 0) this.studio.scrollIntoView();
    this.onPage(page);
  }

  /**
   * Puts the form to its place, and whatever has another place or another form in the scene into the document anew: what
   * a browser has laid out anew does not count as moved, and nothing that is seen moves.
   */
  private putForm(page: Page): void {
    const { form, inspector, progress } = this;
    const moving = ':is(#controls, #inspector, #progress) :focus';
    const focused = this.studio.querySelector<HTMLElement>(moving);
    const { scrollTop } = inspector;
    if (form.parentElement !== this.places[page]) this.places[page].append(form);
    for (const part of [inspector, progress]) part.parentNode?.insertBefore(part, part.nextSibling);
    inspector.scrollTop = scrollTop;
    focused?.focus({ preventScroll: true });
  }
}
