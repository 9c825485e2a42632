import type { DocumentEdit } from '../model/document-edits.js';
import { edgeEdits, flapPlace, type EdgeAction } from '../model/edge-edits.js';
import type { JobResult } from '../model/job.js';
import { SheetEdges, type SheetEdge } from '../model/sheet-edges.js';
import { EdgeCard } from './edge-card.js';
import { edgeLighting, together, type LightsBySheet } from './edge-lighting.js';
import { edgeWords, flapWords, outcomeWords, type EdgeOutcome } from './edge-words.js';
import type { Ending } from './ending.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { sentence } from './sentence.js';
import { followWork } from './sheet-choice.js';
import type { SheetPlace } from './sheet-place.js';
import type { Store } from './store.js';

/** How near the pointer must be to an edge: in mm, but at least in pixels, and that far also from short edges. */
const reach = { mm: 3, pixels: 6, leastPixels: 2 };

export interface EdgeToolListener {
  /** Lights edges on the sheets. */
  light(lights: LightsBySheet): void;
  /** Scrolls to what is lit on a sheet; how far that is below the upper end of the window then, in pixels. */
  reveal(sheet: number): number;
  /** Makes an edit. */
  change(edit: DocumentEdit): Promise<Ending>;
  /** An edge is chosen, or looked for: nothing else is chosen any more. */
  alone(): void;
  /** Finds something else of this name; false if there is nothing. */
  findOther(name: string): boolean;
}

/** Edges on the sheets are pointed at, chosen by a click or by their number, and changed. */
export class EdgeTool extends Panel {
  private readonly line = this.find('#edge-line', HTMLElement);
  private readonly form = this.find('#edge-form', HTMLFormElement);
  private readonly number = this.find('#edge-number', HTMLInputElement);
  private readonly card: EdgeCard;
  private edges: SheetEdges | null = null;
  private pointed: SheetEdge | null = null;
  private chosen: SheetEdge | null = null;
  private outcome = '';

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly listener: EdgeToolListener,
  ) {
    super(place);
    this.card = new EdgeCard(place, {
      act: (action) => void this.act(action),
      close: () => this.close(),
    });
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.search();
    });
    followWork(place, store, { close: () => this.close(), show: () => this.show() });
  }

  /** Takes another result; an edge that was chosen and is there still stays so. */
  offer(result: JobResult): void {
    this.edges = new SheetEdges(result);
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
      this.line.textContent = edge && this.edges ? edgeWords(this.edges, edge) : '';
      this.light();
    }
    return edge !== null;
  }

  /** Chooses the edge at a place; false if there is none. */
  press(place: SheetPlace | null): boolean {
    const edge = place && this.edgeAt(place);
    if (!edge) {
      this.close();
      return false;
    }
    this.choose(edge);
    this.card.keepOff(place.below);
    return true;
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
      this.choose(edge);
      this.card.keepOff(this.listener.reveal(edge.sheet));
      return;
    }
    this.close();
    if (this.listener.findOther(text)) return;
    this.listener.alone();
    const words = `No edge and no piece is called ${text}.`;
    this.card.show({ words, actions: [], busy: false, outcome: '' });
  }

  private choose(edge: SheetEdge): void {
    this.chosen = edge;
    this.outcome = '';
    this.listener.alone();
    this.show();
    this.light();
  }

  /** Chooses no edge any more. */
  close(): void {
    if (this.card.hasFocus) this.number.focus({ preventScroll: true });
    this.chosen = null;
    this.show();
    this.light();
  }

  private async act(action: EdgeAction): Promise<void> {
    const { edges, chosen } = this;
    const edit = edges && chosen && edgeEdits(edges, chosen).get(action);
    if (!edit) return;
    const before = this.state;
    const ending = await this.listener.change(edit);
    // Who has chosen another edge meanwhile sees what came of it on the sheets.
    if (this.chosen?.modelEdge !== chosen.modelEdge) return;
    const { state: after } = this;
    if (ending.type === 'refused') this.outcome = sentence(ending.refusal.params.text);
    else if (ending.type === 'shown' && before && after) {
      this.outcome = outcomeWords({ action, before, after });
    } else this.outcome = '';
    this.show();
  }

  /** What an edit can change at the chosen edge. */
  private get state(): EdgeOutcome['before'] | null {
    const { edges, chosen } = this;
    if (!edges || !chosen) return null;
    return { pieces: edges.result.pieces.length, flap: flapPlace(edges, chosen) };
  }

  private show(): void {
    const { edges, chosen, outcome } = this;
    if (!edges || !chosen) return this.card.show(null);
    const flap = chosen.kind === 'cut' ? ` ${flapWords[flapPlace(edges, chosen)]}` : '';
    const words = `${edgeWords(edges, chosen)}.${flap}`;
    const actions = [...edgeEdits(edges, chosen).keys()];
    this.card.show({ words, actions, busy: this.store.busy, outcome });
  }

  private light(): void {
    const { edges, chosen, pointed } = this;
    const lit = [...new Set([chosen, pointed])].filter((edge) => edge !== null);
    this.listener.light(together(edges ? lit.map((edge) => edgeLighting(edges, edge)) : []));
  }
}
