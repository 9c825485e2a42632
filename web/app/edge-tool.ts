import type { DocumentEdit, LockKind } from '../model/document-edits.js';
import { edgeEdits, flapPlace, heightEdit, lockOf, type EdgeAction } from '../model/edge-edits.js';
import { placesOf, type FindingPlace } from '../model/finding-places.js';
import type { EdgeLock } from '../model/job-options.js';
import { SheetEdges, type SheetEdge } from '../model/sheet-edges.js';
import { flapAt, type SheetFlap } from '../model/sheet-flaps.js';
import type { Vector } from '../model/vector.js';
import { findingsOn, type Finding } from '../model/verdict.js';
import { phraseOf } from '../words/phrase.js';
import { findingWords } from '../words/verdict.js';
import { EdgeCard } from './edge-card.js';
import {
  edgeLighting,
  gripLighting,
  litOnModel,
  lockSigns,
  pieceLighting,
  together,
  viewOf,
} from './edge-lighting.js';
import {
  edgeWords,
  giftWords,
  outcomeWords,
  pieceWords,
  type EdgeOutcome,
  type EdgeState,
} from './edge-words.js';
import type { Ending } from './ending.js';
import type { FinishedRun } from './finished-run.js';
import { FlapPull } from './flap-pull.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { PlaceWalk } from './place-walk.js';
import { sentence } from './sentence.js';
import { followWork } from './sheet-choice.js';
import type { SheetList } from './sheet-list.js';
import type { SheetPlace } from './sheet-place.js';
import type { Store } from './store.js';

/** How near the pointer must be to an edge: in mm, but at least in pixels, and that far also from short edges. */
const reach = { mm: 3, pixels: 6, leastPixels: 2 };

/** Of a card that only tells something. */
const nothing = { actions: [], height: null, busy: false, gift: '', outcome: '', walk: null };

export interface EdgeToolListener {
  /** Lights edges on the model, and looks at it from a direction unless that is null. */
  lightModel(edges: Int32Array, from: Vector | null): void;
  /** Makes an edit. */
  change(edit: DocumentEdit): Promise<Ending>;
  /** An edge is chosen, or looked for: nothing else is chosen any more. */
  alone(): void;
  /** Finds something else of this name; false if there is nothing. */
  findOther(name: string): boolean;
}

/**
 * Edges on the sheets are pointed at, chosen by a click or by their number, and changed; what a verdict is about is
 * walked through.
 */
export class EdgeTool extends Panel {
  private readonly line = this.find('#edge-line', HTMLElement);
  private readonly form = this.find('#edge-form', HTMLFormElement);
  private readonly number = this.find('#edge-number', HTMLInputElement);
  private readonly card: EdgeCard;
  private readonly pull: FlapPull;
  private edges: SheetEdges | null = null;
  private pointed: SheetEdge | null = null;
  private chosen: SheetEdge | null = null;
  /** A piece that a walk is at. */
  private piece: number | null = null;
  private walk: PlaceWalk | null = null;
  private locks: readonly EdgeLock[] = [];
  private outcome = '';

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly sheets: SheetList,
    private readonly listener: EdgeToolListener,
  ) {
    super(place);
    this.card = new EdgeCard(place, {
      act: (action) => void this.act(action),
      setHeight: (height) => void this.setHeight(height),
      step: (by) => this.step(by),
      close: () => this.close(),
    });
    this.pull = new FlapPull(place, store, sheets, {
      preview: (height) => this.card.showHeight(height ?? this.flap?.height ?? null),
      pull: (height) => void this.setHeight(height),
    });
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.search();
    });
    followWork(place, store, { close: () => this.close(), show: () => this.show() });
  }

  /** Takes another result; an edge that was chosen and is there still stays so. */
  offer(run: Pick<FinishedRun, 'result' | 'locks' | 'settings'>): void {
    const { result, locks } = run;
    this.edges = new SheetEdges(result);
    this.locks = locks;
    this.piece = null;
    this.walk = this.walkAfter(run);
    this.sheets.lock(lockSigns(this.told.edges.lockSigns, this.edges, locks));
    this.chosen = this.chosen && this.edges.find(this.chosen.name);
    this.pointed = null;
    this.line.textContent = '';
    this.show();
    this.light();
  }

  /** Lights the edge at a place, and says what it is; false if there is none. */
  point(place: SheetPlace | null): boolean {
    const edge = place && this.edgeAt(place);
    if (edge !== this.pointed) {
      this.pointed = edge;
      this.line.textContent = edge && this.edges ? edgeWords(this.told, this.edges, edge) : '';
      this.light();
    }
    return edge !== null;
  }

  /** Shows where the first thing is that a finding is about, or, when asked once more, the next one. */
  walkThrough(finding: Finding): void {
    if (!this.edges) return;
    if (this.walk?.code !== finding.code) {
      const places = placesOf(finding, this.edges);
      if (places.length === 0) return;
      this.walk = new PlaceWalk(
        finding.code,
        findingWords(this.told.verdict, finding).title,
        places,
      );
    }
    this.step(1);
  }

  /** The walk that goes on in another result. */
  private walkAfter({
    result,
    settings,
  }: Pick<FinishedRun, 'result' | 'settings'>): PlaceWalk | null {
    const { walk, edges } = this;
    if (!walk || !edges) return null;
    const finding = findingsOn(result, settings.margin).find(({ code }) => code === walk.code);
    return finding
      ? walk.resumed(findingWords(this.told.verdict, finding).title, placesOf(finding, edges))
      : null;
  }

  /** Chooses the edge at a place; false if there is none. */
  press(place: SheetPlace | null): boolean {
    // Who takes hold of a flap and lets it go again means no edge beside it.
    if (place && this.holdsFlap(place)) return true;
    const edge = place && this.edgeAt(place);
    if (!edge) {
      this.close();
      return false;
    }
    this.walk = null;
    this.choose({ edge });
    this.card.keepOff(place.below);
    return true;
  }

  /** Whether a press at a place takes the flap of the chosen edge. */
  holdsFlap(place: SheetPlace, isFinger = false): boolean {
    return this.pull.holds(place, isFinger);
  }

  private edgeAt({ sheet, point, mmPerPixel }: SheetPlace): SheetEdge | null {
    const far = Math.max(reach.mm, reach.pixels * mmPerPixel);
    return this.edges?.nearest(sheet, point, far, reach.leastPixels * mmPerPixel) ?? null;
  }

  /** Chooses what has the number or name in the field; once more: the next edge that has the number. */
  private search(): void {
    const text = this.number.value.trim();
    if (text === '' || !this.edges) return;
    const found = this.edges.numbered(text);
    const edge = found[(found.findIndex((one) => one === this.chosen) + 1) % found.length];
    if (edge) {
      this.walk = null;
      this.reveal({ edge });
      return;
    }
    this.close();
    if (this.listener.findOther(text)) return;
    this.listener.alone();
    const words = this.told.edges.notFound(text);
    this.card.show({ words, ...nothing });
  }

  private step(by: 1 | -1): void {
    if (this.walk) this.reveal(this.walk.step(by));
  }

  /** Chooses a place and brings it into view. */
  private reveal(place: FindingPlace): void {
    this.choose(place);
    const at = place.edge ?? this.edges?.result.pieces[place.piece];
    if (at) this.card.keepOff(this.sheets.reveal(at.sheet));
  }

  private choose(place: FindingPlace): void {
    this.chosen = place.edge ?? null;
    this.piece = place.piece ?? null;
    this.outcome = '';
    this.listener.alone();
    this.show();
    this.light(place);
  }

  /** Chooses no edge any more. */
  close(): void {
    if (this.card.hasFocus) this.number.focus({ preventScroll: true });
    this.chosen = this.piece = this.walk = null;
    this.show();
    this.light();
  }

  private async act(action: EdgeAction): Promise<void> {
    const { edges, chosen } = this;
    const edit = edges && chosen && edgeEdits(edges, chosen, this.lock).get(action);
    if (edit) await this.make(action, edit);
  }

  private async setHeight(height: number): Promise<void> {
    const { edges, chosen } = this;
    const edit = edges && chosen && heightEdit(edges, chosen, height);
    if (edit) await this.make({ height }, edit);
  }

  /** Makes an edit at the chosen edge, and tells what came of it. */
  private async make(action: EdgeOutcome['action'], edit: DocumentEdit): Promise<void> {
    const { chosen, state: before } = this;
    if (!chosen) return;
    const ending = await this.listener.change(edit);
    // Who has chosen another edge meanwhile sees what came of it on the sheets.
    if (this.chosen?.modelEdge !== chosen.modelEdge) return;
    const { state: after } = this;
    if (ending.type === 'refused') this.outcome = sentence(phraseOf(this.told, ending.refusal));
    else if (ending.type === 'shown' && before && after) {
      this.outcome = outcomeWords(this.told, { action, before, after });
    } else this.outcome = '';
    this.show();
  }

  private get lock(): LockKind {
    return this.chosen ? lockOf(this.chosen, this.locks) : 'free';
  }

  /** The flap of the chosen edge. */
  private get flap(): SheetFlap | null {
    return this.edges && this.chosen && flapAt(this.edges, this.chosen);
  }

  /** What an edit can change at the chosen edge. */
  private get state(): EdgeState | null {
    const { edges, chosen } = this;
    if (!edges || !chosen) return null;
    return {
      pieces: edges.result.pieces.length,
      flap: flapPlace(edges, chosen),
      height: this.flap?.height ?? 0,
    };
  }

  private show(): void {
    const { edges, chosen, piece, outcome, lock, walk } = this;
    const { busy } = this.store;
    this.pull.offer(this.flap);
    const { edges: told } = this.told;
    if (edges && piece !== null) {
      const words = sentence(pieceWords(this.told, edges.result.pieces[piece]!));
      return this.card.show({ ...nothing, words, walk });
    }
    if (!edges || !chosen) return this.card.show(null);
    const flap = chosen.kind === 'cut' ? told.flaps[flapPlace(edges, chosen)] : '';
    const words = [sentence(edgeWords(this.told, edges, chosen)), flap, told.locks[lock]];
    const actions = [...edgeEdits(edges, chosen, lock).keys()];
    const gift = giftWords(this.told, edges, chosen);
    const text = words.filter(Boolean).join(' ');
    const height = this.flap?.height ?? null;
    this.card.show({ words: text, actions, height, busy, gift, outcome, walk });
  }

  /** Lights what is chosen and what is pointed at; `looked`: what of it the model is turned to. */
  private light(looked: FindingPlace | null = null): void {
    const { edges, chosen, piece, pointed } = this;
    if (!edges) return;
    const lit = [...new Set([chosen, pointed])].filter((edge) => edge !== null);
    const lights = lit.map((edge) => edgeLighting(edges, edge));
    const onModel = lit.flatMap((edge) => litOnModel(edges, { edge }));
    if (piece !== null) {
      lights.push(pieceLighting(edges, piece));
      onModel.push(...litOnModel(edges, { piece }));
    }
    const { flap } = this;
    if (flap) lights.push(gripLighting(flap));
    this.sheets.light(together(lights));
    const from = looked && viewOf(edges, looked);
    this.listener.lightModel(Int32Array.from(onModel), from);
  }
}
