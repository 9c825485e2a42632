import type { Preset } from '../app/options-form.js';
import type { StudioPlace } from '../app/place.js';
import { Studio } from '../app/studio.js';
import markup from '../app/studio.html?raw';
import styles from '../app/styles/studio.css?inline';
import type { TimedEvent } from '../core/protocol.js';
import { lendPool } from './engine-pool.js';

/** The DOM events of a studio, which bubble. */
export interface StudioEventMap {
  /** What its runs tell, as it comes from the engine. */
  'foldwright-event': CustomEvent<TimedEvent>;
  /** It is complete: now there is time for other things. */
  'foldwright-ready': CustomEvent<null>;
}

/** Names of the attributes that fill in fields. */
const presets = ['parts', 'seed', 'paper', 'faces'] as const satisfies readonly (keyof Preset)[];

/** Languages that the studio speaks, the first one where it does not speak the one asked for. */
const languages = ['en'] as const;

/** More workers than this no device has cores for. */
const mostWorkers = 64;

const template = document.createElement('template');
template.innerHTML = markup;

/** Made once for all studios, with the first of them. */
let sheet: CSSStyleSheet | null = null;

function styleSheet(): CSSStyleSheet {
  if (sheet) return sheet;
  // Unlike a style element it is no matter of a page's content security policy.
  sheet = new CSSStyleSheet();
  sheet.replaceSync(styles);
  return sheet;
}

/**
 * `<foldwright-studio>`: a whole studio in a shadow root. Several on a page share the engine's workers
 * and nothing else.
 *
 * | attribute | |
 * |---|---|
 * | `src` | address of a model, from the page; it is fetched and unfolded whenever this is set, one of more than 2000 triangles simplified to 1500 unless `faces` says otherwise |
 * | `parts`, `seed`, `paper`, `faces` | fill in the fields of these names, as the command line's options do; `paper` may also be WxH in mm |
 * | `lang` | language of the words; English for all so far |
 * | `workers` | number of engine workers, 1 to 64; counts for the first studio that needs them |
 * | `whole-page` | the page is for nothing else: files dropped anywhere and Escape pressed anywhere are for the studio |
 *
 * Removed from the page it ends its run and frees its workers; put in again it starts afresh.
 */
export class FoldwrightStudio extends HTMLElement {
  static readonly observedAttributes = ['src', 'lang', ...presets];

  private readonly root = this.attachShadow({ mode: 'open' });
  private studio: Studio | null = null;
  /** Of the studio that is there. */
  private life = new AbortController();
  private readonly engine = lendPool(() => this.workers());

  connectedCallback(): void {
    // An element that is only moved is taken out and put in again in one go.
    if (!this.studio) this.begin();
  }

  disconnectedCallback(): void {
    queueMicrotask(() => {
      if (!this.isConnected) this.end();
    });
  }

  attributeChangedCallback(name: string): void {
    if (!this.studio) return;
    if (name === 'src') this.load();
    else if (name === 'lang') this.speak();
    else this.studio.preset(this.preset([name]));
  }

  private begin(): void {
    this.root.adoptedStyleSheets = [styleSheet()];
    this.root.replaceChildren(template.content.cloneNode(true));
    this.speak();
    this.life = new AbortController();
    const isAlone = this.hasAttribute('whole-page');
    const place: StudioPlace = {
      root: this.root,
      ground: isAlone ? window : this,
      life: this.life.signal,
    };
    this.studio = new Studio(place, () => this.engine.pool(), {
      onReady: () => this.dispatch('foldwright-ready', null),
      onEvent: (event) => this.dispatch('foldwright-event', event),
    });
    this.studio.preset(this.preset(presets));
    void this.studio.start();
    this.load();
  }

  private end(): void {
    this.life.abort();
    this.engine.giveBack();
    this.studio = null;
    this.root.replaceChildren();
  }

  private load(): void {
    const address = this.getAttribute('src');
    if (address) this.studio?.load(address, this.baseURI);
  }

  private preset(names: readonly string[]): Preset {
    const values = names.map((name) => [name, this.getAttribute(name)] as const);
    return Object.fromEntries(values.filter(([, value]) => value !== null));
  }

  private speak(): void {
    const [wanted] = this.lang.toLowerCase().split('-');
    const language = languages.find((name) => name === wanted) ?? languages[0];
    this.root.querySelector('.studio')?.setAttribute('lang', language);
  }

  private workers(): number | undefined {
    const workers = Number(this.getAttribute('workers'));
    const makesSense = Number.isInteger(workers) && workers >= 1 && workers <= mostWorkers;
    return makesSense ? workers : undefined;
  }

  private dispatch<Name extends keyof StudioEventMap>(
    name: Name,
    detail: StudioEventMap[Name]['detail'],
  ): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true }));
  }
}
