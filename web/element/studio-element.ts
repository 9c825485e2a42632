import type { Preset } from '../app/options-form.js';
import type { StudioPlace } from '../app/place.js';
import { Studio } from '../app/studio.js';
import { studioMarkup } from '../app/studio-markup.js';
import styles from '../app/styles/studio.css?inline';
import { personsLanguage } from '../app/language-habit.js';
import type { ChosenModel } from '../app/model-file.js';
import type { TimedEvent } from '../core/protocol.js';
import { spokenOf, type Language } from '../model/languages.js';
import { english } from '../words/en/index.js';
import { wordsOf } from '../words/load.js';
import type { Words } from '../words/words.js';
import { lendPool } from './engine-pool.js';
import { presets } from './studio-attributes.js';
import { sharedStyleSheet } from './style-sheet.js';

/** The DOM events of a studio, which bubble. */
export interface StudioEventMap {
  /** What its runs tell, as it comes from the engine. */
  'foldwright-event': CustomEvent<TimedEvent>;
  /** It is complete: now there is time for other things. */
  'foldwright-ready': CustomEvent<null>;
}

/** More workers than this no device has cores for. */
const mostWorkers = 64;

/** Made once for each language. */
const templates = new Map<Language, HTMLTemplateElement>();

function templateIn(words: Words): HTMLTemplateElement {
  const made = templates.get(words.code);
  if (made) return made;
  const template = document.createElement('template');
  template.innerHTML = studioMarkup(words);
  templates.set(words.code, template);
  return template;
}

const styleSheet = sharedStyleSheet(styles);

/**
 * `<foldwright-studio>`: a whole studio in a shadow root. Several on a page share the engine's workers
 * and nothing else. Removed from the page it ends its run and frees its workers; put in again it starts afresh. What is
 * told of it here is also in `custom-elements.json` and in the tables of `docs/elements.md`, which the build and the
 * formatter make of it.
 *
 * The element itself sets `page`: `bench` once a model is chosen, and `start` where one is to be chosen, for the style
 * of what is around it.
 *
 * @tagname foldwright-studio
 * @attr {string} src - address of a model, from the page; it is fetched and unfolded whenever this is set, one of more than 2000 triangles simplified to 1500 unless `faces` says otherwise
 * @attr {string} parts - fills in the field of this name, as the option of the command line does
 * @attr {string} seed - the same of the seed
 * @attr {string} paper - the same of the paper, which may also be WxH in mm
 * @attr {string} faces - the same of the number of triangles to simplify to
 * @attr {string} options - further options of the command line that have a field, as in an address: `height=150&flaps=6`
 * @attr {string} lang - language of the words on the page and on paper, by its code (BCP 47); English for one that there is not. Without it English, or with `whole-page` that of the person. A change begins the studio anew with the work that is on it, once nothing is being computed
 * @attr {string} workers - number of engine workers, 1 to 64; counts for the first studio that needs them
 * @attr {boolean} whole-page - the page is for nothing else: files dropped anywhere and Escape pressed anywhere are for the studio, and the work is kept as with `autosave`
 * @attr {boolean} autosave - the browser keeps the work by itself, for this origin, and the start screen offers it; without it a visitor of a shop's page leaves nothing behind; counts when the element is put into the page
 */
export class FoldwrightStudio extends HTMLElement {
  static readonly observedAttributes = ['src', 'lang', 'options', ...presets];

  private readonly root = this.attachShadow({ mode: 'open' });
  private studio: Studio | null = null;
  /** Of the studio that is there, or of one that waits for its words. */
  private life = new AbortController();
  private language: Language = 'en';
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
    else if (name === 'lang') void this.speakAnew();
    else if (name === 'options') this.ask();
    else this.studio.preset(this.preset([name]));
  }

  private begin(work: ChosenModel | null = null): void {
    this.life.abort();
    const life = new AbortController();
    this.life = life;
    this.language = this.wantedLanguage;
    const words = wordsOf(this.language);
    if (!(words instanceof Promise)) return this.open(words, work);
    // A studio in another language is better than none.
    void words
      .catch(() => english)
      .then((loaded) => {
        if (!life.signal.aborted) this.open(loaded, work);
      });
  }

  /** @param work to go on with; else what the attributes ask for is loaded */
  private open(words: Words, work: ChosenModel | null): void {
    this.root.adoptedStyleSheets = [styleSheet()];
    this.root.replaceChildren(templateIn(words).content.cloneNode(true));
    const isAlone = this.hasAttribute('whole-page');
    const keeps = isAlone || this.hasAttribute('autosave');
    const place: StudioPlace = {
      words,
      root: this.root,
      ground: isAlone ? window : this,
      life: this.life.signal,
    };
    this.studio = new Studio(place, () => this.engine.pool(), {
      keeps,
      onReady: () => this.dispatch('foldwright-ready', null),
      onEvent: (event) => this.dispatch('foldwright-event', event),
      // For the page around it, which may make room.
      onPage: (page) => this.setAttribute('page', page),
    });
    this.ask();
    this.studio.preset(this.preset(presets));
    void this.studio.start();
    if (work) this.studio.goOn(work);
    else this.load();
  }

  private end(): void {
    this.life.abort();
    this.engine.giveBack();
    this.studio = null;
    this.removeAttribute('page');
    this.root.replaceChildren();
  }

  private load(): void {
    const address = this.getAttribute('src');
    if (address) this.studio?.load(address, this.baseURI);
  }

  private ask(): void {
    const options = this.getAttribute('options');
    if (options) this.studio?.ask(options);
  }

  private preset(names: readonly string[]): Preset {
    const values = names.map((name) => [name, this.getAttribute(name)] as const);
    return Object.fromEntries(values.filter(([, value]) => value !== null));
  }

  private get wantedLanguage(): Language {
    if (this.lang === '' && this.hasAttribute('whole-page')) return personsLanguage();
    return spokenOf([this.lang]);
  }

  /** Begins anew in another language with what is on the page. */
  private async speakAnew(): Promise<void> {
    if (this.language === this.wantedLanguage) return;
    const { studio } = this;
    const work = (await studio?.handOver()) ?? null;
    // Meanwhile it may have been removed, or asked for the language that it speaks.
    if (!studio || studio !== this.studio || this.language === this.wantedLanguage) return;
    this.end();
    this.begin(work);
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
