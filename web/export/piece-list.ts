/** All pieces, with pictures of where they belong. */
import { building as words } from '../words/building.js';
import type { BuildingPlan } from './building-plan.js';
import type { VisibleArea } from './hidden-surfaces.js';
import { drawModel, paperGrey, pieceRgb } from './model-picture.js';
import type { ModelView, ModelViews } from './model-views.js';
import { wrapped, type Page } from './page-layout.js';
import { dotAround, type Frame, type PictureShape } from './picture-shape.js';
import { numberRuns } from './seam-numbers.js';
import { capHeight, shortened } from './text-line.js';
import type { ViewName } from './view-direction.js';

const sizes = { heading: 6, name: 5, text: 2.8 } as const;
const rowHeight = 33;
const pictureWidth = 34;
const gap = 6;
const headingHeight = 12;

/** The model in grey with one piece in its colour. */
function placeOf(views: ModelViews, piece: number, view: ModelView, frame: Frame): PictureShape[] {
  const colourOf = (other: number): readonly number[] =>
    other === piece ? pieceRgb(views, piece) : paperGrey;
  const isThere = (): boolean => true;
  const { areas, scene } = view;
  const shapes = drawModel({ views, view: view.view, scene, areas, isThere, colourOf, frame });
  if (!views.hides(view, piece)) return shapes;
  const alone = views.partly(view.view, (other) => other === piece);
  const own: VisibleArea[] = alone.scene.areas();
  const ownFaces = new Set(alone.faces);
  return [
    ...shapes,
    ...drawModel({
      views,
      view: view.view,
      scene: alone.scene,
      areas: own,
      isThere: (face) => ownFaces.has(face),
      colourOf,
      frame,
    }),
  ];
}

function drawEntry(
  page: Page,
  views: ModelViews,
  plan: BuildingPlan,
  piece: number,
  box: Frame,
): void {
  const { flaps, name, sheet, sources } = views.result.pieces[piece]!;
  const usual: ViewName = 'front-left';
  const view = views.bestFor(piece, usual);
  const isHidden = views.hides(view, piece);
  page.draw(placeOf(views, piece, view, { ...box, width: pictureWidth, height: box.height - 3 }));
  const left = box.left + pictureWidth + 4;
  const room = box.left + box.width - left;
  const top = box.bottom + box.height - 3;
  const colour = `#${pieceRgb(views, piece)
    .map((value) => value.toString(16).padStart(2, '0'))
    .join('')}`;
  const middle = top - 3 - (capHeight * sizes.name) / 2;
  page.draw([{ kind: 'area', colour, walks: [dotAround([left + 2, middle], 2)] }]);
  page.text(
    shortened(name, sizes.name, room - 6),
    [left + 6, top - 3 - capHeight * sizes.name],
    sizes.name,
  );
  const { mountains, valleys } = plan.folds[piece]!;
  const lines = [
    words.sheet({ sheet: sheet + 1 }),
    words.faces({ faces: sources.length, flaps: flaps.edges.length }),
    words.pieceFolds({ folds: mountains + valleys, valleys }),
    ...(isHidden ? [words.hidden()] : []),
  ].flatMap((text) => wrapped(text, sizes.text, room));
  lines.forEach((line, i) => page.text(line, [left, top - 12.5 - 4 * i], sizes.text));
}

/** What is on the sheets beside the pieces. */
function stripWords({ result: { strips } }: ModelViews): string | null {
  if (strips.length === 0) return null;
  const runs = numberRuns(strips.map(({ id }) => String(id)));
  return words.strips({ runs, strips: strips.length });
}

/**
 * As many pages as it takes.
 *
 * @param newPage begins another one
 */
export function drawPieceList(newPage: () => Page, views: ModelViews, plan: BuildingPlan): void {
  let page = newPage();
  const begin = (): { columns: number; rows: number } => {
    const top = page.height - page.margin;
    page.text(words.piecesTitle(), [page.margin, top - capHeight * sizes.heading], sizes.heading);
    const rows = Math.floor((page.height - 2 * page.margin - headingHeight - 6) / rowHeight);
    return { columns: page.isWide ? 3 : 2, rows: Math.max(1, rows) };
  };
  let { columns, rows } = begin();
  let cell = 0;
  // In the order of gluing, which is that of their letters.
  for (const piece of views.result.pieces.keys()) {
    if (cell === columns * rows) {
      page = newPage();
      ({ columns, rows } = begin());
      cell = 0;
    }
    const width = (page.room - (columns - 1) * gap) / columns;
    const [column, row] = [cell % columns, Math.floor(cell / columns)];
    drawEntry(page, views, plan, piece, {
      left: page.margin + column * (width + gap),
      bottom: page.height - page.margin - headingHeight - (row + 1) * rowHeight,
      width,
      height: rowHeight,
    });
    ++cell;
  }
  const strips = stripWords(views);
  if (strips === null) return;
  const lines = wrapped(strips, sizes.text, page.room);
  const used = Math.ceil(cell / columns) * rowHeight + headingHeight;
  let y = page.height - page.margin - used - 5;
  for (const line of lines) {
    if (y < page.margin + 6) {
      page = newPage();
      begin();
      y = page.height - page.margin - headingHeight - 3;
    }
    page.text(line, [page.margin, y], sizes.text);
    y -= 4;
  }
}
