import { KeepAwake } from './keep-awake.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What a small window shows of a result, one at a time. */
export type TabName = 'model' | 'sheets' | 'build' | 'save';

/** The tabs of a small window; a large one shows all of it at once. */
export class Tabs extends Panel {
  private readonly studio = this.find('.studio', HTMLElement);
  private readonly list = this.find('#tabs', HTMLElement);
  private readonly tabs = [...this.list.querySelectorAll<HTMLButtonElement>('[role=tab]')];
  private readonly steps = this.find('#steps-card', HTMLDetailsElement);
  private readonly awake = new KeepAwake(this.place.life, this.list.ownerDocument);

  constructor(place: StudioPlace) {
    super(place);
    for (const tab of this.tabs) {
      tab.addEventListener('click', () => this.show(tab.dataset['tab'] as TabName));
    }
    this.list.addEventListener('keydown', (event) => this.key(event));
    // It is gone where the window is large, or shows no result.
    const observer = new ResizeObserver(() => this.follow());
    observer.observe(this.list);
    place.life.addEventListener('abort', () => observer.disconnect());
    this.show('model');
  }

  /** Shows one of them. */
  show(name: TabName): void {
    this.studio.dataset['tab'] = name;
    for (const tab of this.tabs) {
      const isShown = tab.dataset['tab'] === name;
      tab.setAttribute('aria-selected', String(isShown));
      tab.tabIndex = isShown ? 0 : -1;
    }
    if (name === 'build') this.steps.open = true;
    this.follow();
  }

  /** While someone folds by the steps, nobody touches the screen. */
  private follow(): void {
    this.awake.wanted = this.studio.dataset['tab'] === 'build' && this.list.offsetWidth > 0;
  }

  private key(event: KeyboardEvent): void {
    const { length } = this.tabs;
    const at = this.tabs.findIndex((tab) => tab.matches(':focus'));
    if (at < 0) return;
    const targets: Readonly<Record<string, number>> = {
      ArrowLeft: (at + length - 1) % length,
      ArrowRight: (at + 1) % length,
      Home: 0,
      End: length - 1,
    };
    const tab = this.tabs[targets[event.key] ?? -1];
    if (!tab) return;
    event.preventDefault();
    tab.focus();
    this.show(tab.dataset['tab'] as TabName);
  }
}
