/** All pieces, with pictures of where they belong. */
import type { BuildingWords } from '../words/building.js';
import type { BuildingPlan } from './building-plan.js';
import {
  drawModel,
  fitOf,
  hexOf,
  paperGrey,
  pieceRgb,
  ringAround,
  type Fit,
} from './model-picture.js';
import type { ModelView, ModelViews } from './model-views.js';
import { wrapped, type Page } from './page-layout.js';
import { dotAround, type Frame, type PictureShape } from './picture-shape.js';
import { capHeight, shortened } from './text-line.js';

const sizes = { heading: 6, name: 5, text: 2.8 } as const;
const rowHeight = 33;
const pictureWidth = 34;
const gap = 6;
const headingHeight = 12;
/** The note at the foot of the page. */
const noteHeight = 6;
const lineHeight = 4;

export interface PieceListInput {
  views: ModelViews;
  plan: BuildingPlan;
  /** Whether the list shows where pieces are. */
  hasPictures: boolean;
  words: BuildingWords;
}

/** The model in grey with one piece in its colour. */
function placeOf(views: ModelViews, piece: number, view: ModelView, frame: Frame): PictureShape[] {
  const colourOf = (other: number): readonly number[] =>
    other === piece ? pieceRgb(views, piece) : paperGrey;
  const isThere = (): boolean => true;
  const { areas, scene } = view;
  const fit = fitOf(views, view.view, frame);
  const shapes = drawModel({ views, view: view.view, scene, areas, isThere, colourOf, fit });
  if (views.hides(view, piece)) return [...shapes, ...aloneIn(views, piece, view, fit)];
  return [...shapes, ...ringAround(views, areas, piece, fit)];
}

/** A piece as if nothing were in front of it. */
function aloneIn(views: ModelViews, piece: number, { view }: ModelView, fit: Fit): PictureShape[] {
  const { faces, scene } = views.partly(view, (other) => other === piece);
  const there = new Set(faces);
  const areas = scene.areas();
  const isThere = (face: number): boolean => there.has(face);
  const colourOf = (): readonly number[] => pieceRgb(views, piece);
  return [
    ...drawModel({ views, view, scene, areas, isThere, colourOf, fit }),
    ...ringAround(views, areas, piece, fit),
  ];
}

function wordsFor({ plan, views, words, hasPictures }: PieceListInput, piece: number): string[] {
  const { flaps, sheet, sources } = views.result.pieces[piece]!;
  const { mountains, valleys } = plan.folds[piece]!;
  const isHidden = hasPictures && views.hides(views.bestFor(piece, 'front-left'), piece);
  return [
    words.sheet({ sheet: sheet + 1 }),
    words.faces({ faces: sources.length, flaps: flaps.edges.length }),
    words.pieceFolds({ folds: mountains + valleys, valleys }),
    ...(isHidden ? [words.hidden()] : []),
  ];
}

function drawEntry(page: Page, input: PieceListInput, piece: number, box: Frame): void {
  const { hasPictures, views } = input;
  if (hasPictures) {
    const frame = { ...box, width: pictureWidth, height: box.height - 3 };
    page.draw(placeOf(views, piece, views.bestFor(piece, 'front-left'), frame));
  }
  const left = box.left + pictureWidth + 4;
  const room = box.left + box.width - left;
  const top = box.bottom + box.height - 3;
  const baseline = top - 3 - capHeight * sizes.name;
  const colour = hexOf(pieceRgb(views, piece));
  const dot = dotAround([left + 2, baseline + (capHeight * sizes.name) / 2], 2);
  page.draw([{ kind: 'area', colour, walks: [dot] }]);
  const { name } = views.result.pieces[piece]!;
  page.text(shortened(name, sizes.name, room - 6), [left + 6, baseline], sizes.name);
  wordsFor(input, piece)
    .flatMap((text) => wrapped(text, sizes.text, room))
    .forEach((line, i) => page.text(line, [left, top - 12.5 - lineHeight * i], sizes.text));
}

/** Pages with a heading and so many cells below it. */
class Cells {
  private page: Page;
  private used = 0;

  constructor(
    private readonly newPage: () => Page,
    private readonly words: BuildingWords,
  ) {
    this.page = this.begin();
  }

  /** The next cell, on another page if need be. */
  next(): { page: Page; box: Frame } {
    if (this.used === this.columns * this.rows) this.page = this.begin();
    const { columns, page, used } = this;
    const width = (page.room - (columns - 1) * gap) / columns;
    const left = page.margin + (used % columns) * (width + gap);
    const bottom = this.top - (Math.floor(used / columns) + 1) * rowHeight;
    ++this.used;
    return { page, box: { left, bottom, width, height: rowHeight } };
  }

  /** A text below all cells. */
  close(text: string): void {
    const lines = wrapped(text, sizes.text, this.page.room);
    let y = this.top - Math.ceil(this.used / this.columns) * rowHeight - lineHeight;
    for (const line of lines) {
      if (y < this.page.margin + noteHeight) {
        this.page = this.begin();
        y = this.top - lineHeight;
      }
      this.page.text(line, [this.page.margin, y], sizes.text);
      y -= lineHeight;
    }
  }

  private get columns(): number {
    return this.page.isWide ? 3 : 2;
  }

  private get rows(): number {
    return Math.max(1, Math.floor((this.top - this.page.margin - noteHeight) / rowHeight));
  }

  /** Lower edge of the heading. */
  private get top(): number {
    return this.page.height - this.page.margin - headingHeight;
  }

  private begin(): Page {
    const page = this.newPage();
    const top = page.height - page.margin;
    page.text(
      this.words.piecesTitle(),
      [page.margin, top - capHeight * sizes.heading],
      sizes.heading,
    );
    this.used = 0;
    return page;
  }
}

/** What is on the sheets beside the pieces. */
function stripWords({ views, words }: PieceListInput): string | null {
  const { strips } = views.result;
  if (strips.length === 0) return null;
  const runs = strips.map(({ id }) => id);
  return words.strips({ runs, strips: strips.length });
}

/**
 * As many pages as it takes.
 *
 * @param newPage begins another one
 */
export function drawPieceList(newPage: () => Page, input: PieceListInput): void {
  const cells = new Cells(newPage, input.words);
  // In the order in which they have their letters.
  for (const piece of input.views.result.pieces.keys()) {
    const { box, page } = cells.next();
    drawEntry(page, input, piece, box);
  }
  const strips = stripWords(input);
  if (strips !== null) cells.close(strips);
}
