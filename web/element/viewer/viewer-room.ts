/** What is in the shadow root of a viewer: pictures, controls and a line of words. */
import { partColour } from '../../model/part-colours.js';
import { FoldPlayer } from '../../view/fold-player.js';
import { partHatch } from '../../view/part-hatches.js';
import { sharedPlaces } from '../../view/model-places.js';
import { modelView } from '../../view/model-view.js';
import { netPattern } from '../../view/net-pattern.js';
import { sheetPicture } from '../../view/sheet-picture.js';
import type { ViewerWords } from '../../words/en/viewer.js';
import { make } from '../../app/dom.js';
import { canFold, labelsOf } from '../../read/fold/folded-nets.js';
import type { Exhibit, NetPicture } from './exhibit.js';

/** How a viewer looks, by its attributes. */
export interface RoomLook {
  view: 'model' | 'nets' | 'both';
  controls: boolean;
  /** Nothing can be asked for but another view of the model. */
  readonly: boolean;
  /** In place of the model's name, for screen readers. */
  alt: string;
  /** Address of a picture; empty for none. */
  poster: string;
  /** Formats that can be downloaded. */
  formats: readonly string[];
  /** What it says. */
  words: ViewerWords;
}

/** What a person does. */
export interface RoomListener {
  /** The button on the poster: show, or unfold. */
  onGo(): void;
  onCancel(): void;
  onTime(time: number): void;
  onDownload(format: string): void;
  /** A piece was clicked, or what is beside all of them. */
  onChoose(parts: number[]): void;
}

/** Something that is said. */
export type Told = (words: ViewerWords) => string;

/** What the viewer waits for. */
export type Offer = 'show' | 'unfold' | 'cancel' | null;

export class ViewerRoom {
  private readonly picture = make('div', { className: 'picture' });
  private readonly model = part(make('div', { className: 'model' }, this.picture), 'model');
  private readonly nets = part(make('div', { className: 'nets', tabIndex: 0 }), 'nets');
  private readonly image = make('img', { alt: '' });
  private readonly go = part(make('button', { type: 'button' }), 'button');
  private readonly poster = part(make('div', { className: 'poster' }), 'poster');
  private readonly slider = part(
    make('input', { type: 'range', min: '0', max: '1', step: '0.005', value: '1' }),
    'slider',
  );
  private readonly play = part(make('button', { type: 'button' }), 'button');
  private readonly downloads = make('span', { className: 'downloads' });
  private readonly controls = part(make('div', { className: 'controls' }), 'controls');
  private readonly status = part(make('p', { className: 'status' }), 'status');
  private readonly player = new FoldPlayer((time) => this.onTime(time));
  private readonly view: ReturnType<typeof modelView>;
  private exhibit: Exhibit | null = null;
  private labels = new Int32Array();
  private offered: Offer = null;
  private told: Told = () => '';

  /** @param life ends what draws and moves */
  constructor(
    root: ShadowRoot,
    life: AbortSignal,
    private look: RoomLook,
    private readonly listener: RoomListener,
  ) {
    this.view = modelView(this.picture, sharedPlaces, life, {
      onFailure: () => this.tell(({ noPicture }) => noPicture),
      onPoint: ({ face, why }) => {
        if (why !== 'over') this.choose(face);
      },
      isPainting: () => false,
      onPaint: () => undefined,
    });
    this.status.setAttribute('role', 'status');
    const slot = make('slot', { name: 'poster' }, this.image);
    this.poster.append(slot, this.go);
    this.controls.append(this.play, this.slider, this.downloads);
    const views = make('div', { className: 'views' }, this.model, this.nets);
    const all = part(make('div', { className: 'viewer' }), 'base');
    all.append(views, this.status, this.controls, this.poster);
    root.replaceChildren(all);
    this.go.addEventListener('click', () => this.onGo());
    this.slider.addEventListener('input', () => this.jump(this.slider.valueAsNumber));
    this.play.addEventListener('click', () => this.onPlay());
    life.addEventListener('abort', () => this.player.halt());
    this.update(look);
  }

  get time(): number {
    return this.player.time;
  }

  /** Takes another look. */
  update(look: RoomLook): void {
    const isSpokenAnew = look.words !== this.look.words;
    this.look = look;
    const { exhibit } = this;
    const { alt, words } = look;
    this.image.hidden = look.poster === '';
    if (look.poster !== '' && this.image.getAttribute('src') !== look.poster) {
      this.image.src = look.poster;
    }
    this.image.alt = alt;
    this.model.hidden = look.view === 'nets';
    this.nets.hidden = look.view === 'model';
    const isShown = exhibit !== null;
    this.poster.hidden = isShown && this.offered === null;
    this.controls.hidden = !look.controls || !isShown || !canFold(exhibit);
    if (isShown) {
      const about = { name: alt || exhibit.title, pieces: exhibit.pieces.length };
      // Before, there is nothing to see, to name or to turn.
      this.picture.setAttribute('role', 'img');
      this.picture.setAttribute('aria-label', words.model(about));
      this.picture.tabIndex = 0;
      if (!this.model.hidden) void this.view.open();
      if (isSpokenAnew) this.fillNets(exhibit);
    }
    this.slider.setAttribute('aria-label', words.slider);
    this.sayTime();
    this.fillStatus();
    this.fillDownloads();
    this.fillButtons();
  }

  /** Shows a model that is folded. */
  show(exhibit: Exhibit): void {
    this.exhibit = exhibit;
    this.labels = Int32Array.from(labelsOf(exhibit));
    const { model, pieces } = exhibit;
    this.view.post({ type: 'model', vertices: model.vertices, faces: model.faces });
    this.view.post({ type: 'labels', labels: this.labels });
    if (canFold(exhibit)) this.view.post({ type: 'folding', model, pieces: [...pieces] });
    this.player.begin(pieces.length);
    this.fillNets(exhibit);
    this.offer(null);
    this.onTime(1);
  }

  /** What the button over the picture does; none for null. */
  offer(offer: Offer): void {
    this.offered = offer;
    this.update(this.look);
  }

  /** A line of words, in those of whatever language is wanted; none if it is empty. */
  tell(told: Told): void {
    this.told = told;
    this.fillStatus();
  }

  /** Goes to a time at once. */
  jump(time: number): void {
    if (this.exhibit && canFold(this.exhibit)) this.player.jump(time);
  }

  /** Goes to a time by and by. */
  async playTo(time: number): Promise<void> {
    if (!this.exhibit || !canFold(this.exhibit)) return;
    const playing = this.player.play(time);
    this.fillButtons();
    await playing;
    this.fillButtons();
  }

  private onGo(): void {
    if (this.offered === 'cancel') this.listener.onCancel();
    else this.listener.onGo();
  }

  private onPlay(): void {
    if (this.player.isPlaying) {
      this.player.halt();
      return;
    }
    if (this.player.time >= 1) this.player.jump(0);
    void this.playTo(1);
  }

  private onTime(time: number): void {
    this.slider.value = String(time);
    this.sayTime();
    this.view.post({ type: 'time', time });
    this.listener.onTime(time);
  }

  private choose(face: number): void {
    const part = this.labels[face] ?? -1;
    const parts = part < 0 ? [] : [part];
    this.view.post({ type: 'selected', parts });
    this.listener.onChoose(parts);
  }

  private sayTime(): void {
    const { time } = this.player;
    const { flat, folded, foldedBy } = this.look.words;
    const said = time === 0 ? flat : time === 1 ? folded : foldedBy({ time });
    this.slider.setAttribute('aria-valuetext', said);
  }

  private fillStatus(): void {
    const text = this.told(this.look.words);
    // Said once more it would be spoken once more.
    if (this.status.textContent !== text) this.status.textContent = text;
  }

  private fillNets(exhibit: Exhibit): void {
    const { nets, pieces, title } = exhibit;
    const about = this.look.words.nets({ name: title, pieces: pieces.length });
    this.nets.setAttribute('role', 'group');
    this.nets.setAttribute('aria-label', about);
    this.nets.replaceChildren(...nets.map((net) => this.netOf(exhibit, net)));
  }

  private netOf({ pieces, sheets, title }: Exhibit, net: NetPicture): Element {
    const { words } = this.look;
    if (net.kind === 'pattern') {
      return netPattern(net.pieces, words.nets({ name: title, pieces: pieces.length }));
    }
    const here = pieces.filter(({ sheet }) => sheet === net.sheet);
    const paints = new Map(
      here.map(({ name, part }) => [name, { colour: partColour(part), hatch: partHatch(part) }]),
    );
    const about = words.sheet({ sheet: net.sheet + 1, sheets });
    return make('div', { className: 'sheet' }, sheetPicture(net.svg, paints, about));
  }

  private fillButtons(): void {
    const { offered } = this;
    const { words } = this.look;
    const isAllowed = offered === 'show' || !this.look.readonly;
    this.go.hidden = offered === null || !isAllowed;
    if (offered) this.go.textContent = words[offered];
    this.play.textContent = this.player.isPlaying ? words.pause : words.play;
  }

  private fillDownloads(): void {
    const { formats, readonly, words } = this.look;
    const wanted = readonly ? [] : formats;
    const buttons = wanted.map((format) => {
      const button = make('button', { type: 'button' }, format.toUpperCase());
      button.addEventListener('click', () => this.listener.onDownload(format));
      return part(button, 'button');
    });
    this.downloads.replaceChildren(...buttons);
    this.downloads.setAttribute('role', 'group');
    this.downloads.setAttribute('aria-label', words.downloads);
  }
}

/** Lets the page around style an element. */
function part<E extends Element>(element: E, name: string): E {
  element.part.add(name);
  return element;
}
