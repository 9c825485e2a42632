import { saveFile } from '../../app/save-file.js';
import type { Options } from '../../api/written-options.js';
import type { Report } from '../../export/report.js';
import type { ExportFormat, WrittenFile } from '../../export/formats.js';
import type { TimedEvent } from '../../core/protocol.js';
import type { ModelFile, ModelFiles } from '../../model/model-files.js';
import { spokenOf, type Language } from '../../model/languages.js';
import { viewer as english, type ViewerWords } from '../../words/en/viewer.js';
import { viewerWordsOf } from '../../words/viewer-words.js';
import type { Exhibit } from './exhibit.js';
import { reflectAttributes, reflected } from './viewer-attributes.js';
import type { ViewerEngine, Wishes } from './viewer-engine.js';
import { ViewerError } from './viewer-fault.js';
import { ViewerRoom, type RoomLook } from './viewer-room.js';
import { exhibitOf, filesOf, isFold, type ViewerSource } from './viewer-source.js';
import { sharedStyleSheet } from '../style-sheet.js';
import styles from './viewer.css?inline';

/** The events of a viewer, as the manifest of the elements has them, too; all bubble and leave shadow roots. */
export interface ViewerEventMap {
  /** A model is there; shown already, if it came with its nets. */
  load: CustomEvent<{ name: string; isShown: boolean }>;
  /** A model was unfolded, and is shown. */
  unfold: CustomEvent<{ report: Report }>;
  /** What the engine tells meanwhile. */
  'foldwright-event': CustomEvent<TimedEvent>;
  /** It was folded or unfolded, to a time from 0 (flat) to 1 (the model). */
  'fold-change': CustomEvent<{ time: number }>;
  /** A piece was clicked: its part, counted from 1; none beside all pieces. */
  'selection-change': CustomEvent<{ parts: number[] }>;
  /** Files are about to be saved, unless the event is cancelled. */
  'before-download': CustomEvent<{ format: ExportFormat; files: readonly WrittenFile[] }>;
  /** Something cannot be loaded, shown or unfolded. */
  error: CustomEvent<{ code: string; message: string }>;
}

export interface UnfoldOptions {
  /** Ends it; the promise then rejects with the signal's reason. */
  signal?: AbortSignal;
}

/** Options of a run that attributes give. */
const runOptions = ['parts', 'seed', 'paper', 'solver', 'flaps'] as const;

/** Pages are also made where there is no DOM; there the class is never used. */
const Base = globalThis.HTMLElement ?? class {};

const styleSheet = sharedStyleSheet(styles);

/**
 * `<foldwright-viewer>`: a paper model to turn, unfold and download. Removed from the page it ends its work and frees
 * workers and graphics; put in again it starts afresh. What is told of it here is also in `custom-elements.json` and in
 * the tables of `docs/elements.md`, which the build and the formatter make of it. The file is longer than others for that.
 *
 * @tagname foldwright-viewer
 * @attr {string} lang - language of the words on the page and on paper, by its code (BCP 47): `en`, `de`, `es`, `fr` or `ja`; English without it, and for any other
 * @slot poster - what is shown until the model is, in place of the attribute `poster`
 *
 * @csspart base - all of the viewer
 * @csspart model - the model in 3D
 * @csspart nets - the nets
 * @csspart poster - what is shown until the model is
 * @csspart button - each button
 * @csspart controls - the slider and the buttons beside it
 * @csspart slider - the slider that folds the model
 * @csspart status - the line of words
 *
 * @cssprop --foldwright-background - colour behind everything
 * @cssprop --foldwright-text - colour of words
 * @cssprop --foldwright-accent - colour of buttons
 * @cssprop --foldwright-accent-text - colour of words on buttons
 * @cssprop --foldwright-line - colour of lines
 * @cssprop --foldwright-font - font of words
 */
export class FoldwrightViewer extends Base {
  static readonly observedAttributes = [...reflected, 'fold', 'lang'];

  /**
   * Address of a `.fold` file of Foldwright, which is shown with its nets and folding, or of a project or model, which is
   * fetched and unfolded when it is asked for.
   * @attr
   */
  declare src: string;
  /**
   * What it is, for who does not see it.
   * @attr
   */
  declare alt: string;
  /**
   * Address of a picture that is shown first.
   * @attr
   */
  declare poster: string;
  /**
   * `eager`: a `.fold` file is fetched at once, else when the viewer comes into view.
   * @attr
   */
  declare loading: string;
  /**
   * `interaction`: a `.fold` file waits for a button, too.
   * @attr
   */
  declare reveal: string;
  /**
   * `model`, `nets` or `both`; `model` without it.
   * @attr
   */
  declare view: string;
  /**
   * Number of parts, for unfolding.
   * @attr
   */
  declare parts: string;
  /**
   * Of the search, for unfolding: the same seed, the same bytes.
   * @attr
   */
  declare seed: string;
  /**
   * Size of the sheets, for unfolding: a name or WxH in mm.
   * @attr
   */
  declare paper: string;
  /**
   * `tree` or `genetic`, for unfolding; `tree` without it.
   * @attr
   */
  declare solver: string;
  /**
   * Height of the flaps in mm, or `none`, for unfolding; 5 without it.
   * @attr
   */
  declare flaps: string;
  /**
   * Length of the longest side of the finished model in mm, for unfolding; without it the largest piece just fits its
   * sheet.
   * @attr target-size
   */
  declare targetSize: string;
  /**
   * `light`, `dark`, or `auto` as the device has it; `light` without it.
   * @attr
   */
  declare theme: string;
  /**
   * Names of formats with spaces between, for the controls: `pdf svg fold`; of a `.fold` file there is only `fold`.
   * @attr download-formats
   */
  declare downloadFormats: string;
  /**
   * Shows a slider and a button that fold the model, and the downloads.
   * @attr
   */
  declare controls: boolean;
  /**
   * Leaves out the buttons that unfold and download.
   * @attr readonly
   */
  declare readOnly: boolean;

  private room: ViewerRoom | null = null;
  /** Of the room that is there. */
  private life = new AbortController();
  /** Of what is being loaded or unfolded. */
  private work: AbortController | null = null;
  /** What was loaded last. */
  private files: ModelFiles | null = null;
  private exhibit: Exhibit | null = null;
  /** The FOLD file that is shown as it came; null for what was unfolded here. */
  private foldFile: ModelFile | null = null;
  private words: ViewerWords = english;
  private engine: ViewerEngine | null = null;

  /**
   * How far the model is folded at first, from 0 (flat) to 1. The property tells how far it is now; to set it sets the
   * attribute.
   * @attr
   */
  get fold(): number {
    return this.room?.time ?? this.wantedFold;
  }

  set fold(time: number) {
    this.setAttribute('fold', String(time));
  }

  connectedCallback(): void {
    // An element that is only moved is taken out and put in again in one go.
    if (!this.room) this.begin();
  }

  disconnectedCallback(): void {
    queueMicrotask(() => {
      if (!this.isConnected) this.end();
    });
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    if (!this.room || before === now) return;
    if (name === 'src') this.plan();
    else if (name === 'lang') void this.speak();
    else if (name === 'fold') this.room.jump(this.wantedFold);
    else this.room.update(this.look);
  }

  /**
   * Takes a model in place of the one before. A `.fold` file of Foldwright is shown at once, anything else when it
   * is unfolded. Rejects with a `ViewerError` for what cannot be loaded or shown.
   */
  loadModel(source: ViewerSource): Promise<void> {
    return this.working(undefined, (signal) => this.load(source, signal));
  }

  /**
   * Unfolds the model, with the engine, which is loaded for it. Rejects with a `ViewerError`, with a `JobError` for a
   * model that cannot be used, and with the reason of `signal` or `cancel` when it is ended; what is shown stays then.
   */
  unfold({ signal }: UnfoldOptions = {}): Promise<Report> {
    return this.working(signal, async (ended) => {
      if (!this.files && this.src !== '') await this.load(this.src, ended);
      const { files, room } = this;
      if (!files || !room || isFold(files[0]!.name)) throw new ViewerError('no-model');
      room.offer('cancel');
      const engine = await this.startEngine();
      const exhibit = await engine.unfold(files, this.wishes, {
        signal: ended,
        onEvent: (event) => this.hear(event),
      });
      this.show(exhibit, null);
      const { report } = engine.current!;
      this.tell('unfold', { report });
      return report;
    });
  }

  /** Ends what is being loaded or unfolded. */
  cancel(): void {
    this.work?.abort();
  }

  /**
   * Writes what is shown in a format. Of a `.fold` file that is only itself.
   *
   * @param options as the command line has them, in camel case
   */
  async exportAs(format: ExportFormat, options: Options = {}): Promise<WrittenFile[]> {
    const { foldFile } = this;
    if (!this.exhibit) throw new ViewerError('not-unfolded');
    if (!foldFile) return this.engine!.current!.export(format, options);
    if (format === 'fold') return [{ name: foldFile.name, bytes: foldFile.bytes }];
    throw new ViewerError('not-written');
  }

  /**
   * Writes the model that was loaded last as a project (`.foldwright`): with its nets and its history if it was unfolded,
   * else with what the attributes ask for, to be unfolded when it is opened. A project that was not touched is returned as
   * it came. Rejects with a `ViewerError` if there is no model, as in a `.fold` file, and as `unfold` does.
   */
  async saveProject(): Promise<WrittenFile> {
    const { signal } = this.life;
    if (!this.files && this.src === '') throw new ViewerError('no-model');
    const files = this.files ?? (await filesOf(this.src, this.baseURI, signal));
    if (isFold(files[0]!.name)) throw new ViewerError('not-written');
    const engine = await this.startEngine();
    return engine.project(files, this.wishes, signal);
  }

  /**
   * Folds the model by and by, to a time from 0 (flat) to 1; at once for people who want no movement, and with
   * `instant`. Ends when it is there, or somebody moves it elsewhere.
   */
  async foldTo(time: number, { instant = false } = {}): Promise<void> {
    const to = Math.min(Math.max(time, 0), 1);
    const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (instant || isStill) this.room?.jump(to);
    else await this.room?.playTo(to);
  }

  private get wantedFold(): number {
    const time = Number(this.getAttribute('fold') ?? 1);
    return time >= 0 && time <= 1 ? time : 1;
  }

  private get look(): RoomLook {
    const { alt, controls, downloadFormats, poster, readOnly, view } = this;
    const wanted = downloadFormats.split(/[\s,]+/);
    // A file that is shown as it came gives nothing but itself.
    return {
      view: view === 'nets' || view === 'both' ? view : 'model',
      controls,
      readonly: readOnly,
      alt,
      poster: poster === '' ? '' : new URL(poster, this.baseURI).href,
      formats: wanted.filter((format) => format === 'fold' || (format !== '' && !this.foldFile)),
      words: this.words,
    };
  }

  private get language(): Language {
    return spokenOf([this.lang]);
  }

  private get wishes(): Wishes {
    const values = runOptions.map((name) => [name, this.getAttribute(name)] as const);
    const given = Object.fromEntries(values.filter(([, value]) => value !== null)) as Options;
    const options = { ...given, lang: this.language };
    return { options, targetSize: this.getAttribute('target-size') };
  }

  /** Takes the words of the language that is wanted, once they are there; until then it goes on in those that it has. */
  private async speak(): Promise<void> {
    const { language } = this;
    // A viewer in another language is better than none.
    const words = await Promise.resolve(viewerWordsOf(language)).catch(() => english);
    if (language !== this.language) return;
    this.words = words;
    this.room?.update(this.look);
  }

  private begin(): void {
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
    root.adoptedStyleSheets = [styleSheet()];
    this.life = new AbortController();
    this.room = new ViewerRoom(root, this.life.signal, this.look, {
      onGo: () => this.onGo(),
      onCancel: () => this.cancel(),
      onTime: (time) => this.tell('fold-change', { time }),
      onDownload: (format) => void this.download(format as ExportFormat),
      onChoose: (parts) => this.tell('selection-change', { parts: parts.map((part) => part + 1) }),
    });
    void this.speak();
    // What a program has given is still there after a move to another page.
    if (this.exhibit) this.show(this.exhibit, this.foldFile);
    else this.plan();
  }

  private end(): void {
    this.work?.abort(new ViewerError('removed'));
    this.life.abort();
    this.engine?.close();
    this.engine = this.room = this.files = this.exhibit = this.foldFile = null;
    this.shadowRoot?.replaceChildren();
  }

  /** Decides when the model at `src` is fetched. */
  private plan(): void {
    this.cancel();
    this.files = null;
    const { src, reveal, loading, room } = this;
    if (src === '') return room?.offer(null);
    if (!isFold(src)) return room?.offer('unfold');
    if (reveal === 'interaction') return room?.offer('show');
    if (loading === 'eager') return this.follow(this.loadModel(src));
    const { signal } = this.life;
    const observer = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      observer.disconnect();
      if (this.src === src && !signal.aborted) this.follow(this.loadModel(src));
    });
    observer.observe(this);
    signal.addEventListener('abort', () => observer.disconnect());
  }

  private onGo(): void {
    if (!this.files && isFold(this.src)) this.follow(this.loadModel(this.src));
    else this.follow(this.unfold());
  }

  private async load(source: ViewerSource, signal: AbortSignal): Promise<void> {
    const files = await filesOf(source, this.baseURI, signal);
    signal.throwIfAborted();
    const [first] = files;
    const { room } = this;
    if (!first || !room) throw new ViewerError('no-model');
    const isShown = isFold(first.name);
    const exhibit = isShown ? exhibitOf(first) : null;
    this.files = files;
    if (exhibit) this.show(exhibit, first);
    else room.offer('unfold');
    this.tell('load', { name: first.name, isShown });
  }

  private show(exhibit: Exhibit, foldFile: ModelFile | null): void {
    this.exhibit = exhibit;
    this.foldFile = foldFile;
    const { room } = this;
    room?.update(this.look);
    room?.show(exhibit);
    room?.tell(() => '');
    if (this.wantedFold < 1) this.room?.jump(this.wantedFold);
  }

  /** Does something in place of whatever is being done. */
  private async working<Value>(
    signal: AbortSignal | undefined,
    work: (signal: AbortSignal) => Promise<Value>,
  ): Promise<Value> {
    this.work?.abort();
    const own = new AbortController();
    this.work = own;
    const { signal: end } = own;
    const pass = (): void => own.abort(signal?.reason);
    if (signal?.aborted) pass();
    signal?.addEventListener('abort', pass, { once: true, signal: end });
    this.room?.tell(() => '');
    try {
      return await work(end);
    } catch (error) {
      if (!end.aborted) this.complain(error);
      throw error;
    } finally {
      if (this.work === own) {
        this.work = null;
        this.offerAgain();
      }
    }
  }

  /** What can be asked for when nothing is being done. */
  private offerAgain(): void {
    const name = this.files?.[0]?.name ?? this.src;
    if (this.exhibit || name === '') this.room?.offer(null);
    else this.room?.offer(isFold(name) ? 'show' : 'unfold');
  }

  private complain(error: unknown): void {
    const message = error instanceof Error ? error.message : String(error);
    const { code = 'internal' } = error as { code?: string };
    if (error instanceof ViewerError) this.room?.tell(({ faults }) => faults[error.code]);
    else void this.tellFault(error, message);
    this.tell('error', { code, message });
  }

  /** Tells what only the engine can say, in the words of the viewer's language. */
  private async tellFault(error: unknown, message: string): Promise<void> {
    const { engine, language, room, work } = this;
    const told = (await engine?.faultIn(language, error).catch(() => null)) ?? message;
    // Something else may be going on by then.
    if (this.work === work || this.work === null) room?.tell(() => told);
  }

  /** For what nobody waits for: its failures were told. */
  private follow(work: Promise<unknown>): void {
    work.catch(() => undefined);
  }

  private async startEngine(): Promise<ViewerEngine> {
    if (this.engine) return this.engine;
    const { signal } = this.life;
    const { ViewerEngine } = await import('./viewer-engine.js');
    if (signal.aborted) throw new ViewerError('removed');
    this.engine ??= new ViewerEngine();
    return this.engine;
  }

  private hear(event: TimedEvent): void {
    if (event.type === 'stage')
      this.room?.tell(({ percent }) => percent({ share: event.progress }));
    this.tell('foldwright-event', event);
  }

  private async download(format: ExportFormat): Promise<void> {
    try {
      const files = await this.exportAs(format);
      if (!this.tell('before-download', { format, files })) return;
      const [file] = files;
      if (files.length === 1) return saveFile(file!.name, file!.bytes, 'application/octet-stream');
      const { zipped } = await import('../../export/zip.js');
      saveFile(`${this.exhibit!.title}-${format}.zip`, zipped(files), 'application/zip');
    } catch (error) {
      this.complain(error);
    }
  }

  /** Whether nobody has cancelled it. */
  private tell<Name extends keyof ViewerEventMap>(
    name: Name,
    detail: ViewerEventMap[Name]['detail'],
  ): boolean {
    const cancelable = name === 'before-download';
    return this.dispatchEvent(
      new CustomEvent(name, { detail, bubbles: true, composed: true, cancelable }),
    );
  }
}

reflectAttributes(FoldwrightViewer.prototype);
