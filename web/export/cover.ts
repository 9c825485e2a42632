/** The cover: the model from several sides, and all that a person wants to know before building it. */
import { extentsOf } from '../model/bounds.js';
import { buildingTime } from '../model/building-time.js';
import type { JobResult } from '../model/job.js';
import type { BuildingWords } from '../words/building.js';
import type { BuildingPlan } from './building-plan.js';
import type { Look } from './line-style.js';
import { drawModel, fitOf, pieceRgb, reachOf } from './model-picture.js';
import type { ModelView, ModelViews } from './model-views.js';
import { wrapped, type Page } from './page-layout.js';
import { middlesOf, placeLetters } from './picture-letters.js';
import { dotAround, type Frame } from './picture-shape.js';
import type { Point } from './point.js';
import { capHeight, shortened, widthAtMost } from './text-line.js';
import type { ViewName } from './view-direction.js';

export interface CoverInput {
  title: string;
  result: JobResult;
  plan: BuildingPlan;
  views: ModelViews;
  look: Look;
  flatFold: number;
  words: BuildingWords;
}

const sizes = { title: 9, subtitle: 4, letter: 3.6, small: 2.6, text: 3 } as const;
const gap = 6;
const captionHeight = 5;
/** Names longer than this stand shortened beside a picture; mm. */
const longestName = 20;
/** Over the whole picture: a piece that shows less is not to be seen in it. */
const leastShare = 0.003;
const thin = { width: 0.1, colour: '#333333', dash: [] };

/** The first two views, and up to two more as long as they show pieces that the others do not. */
export function chosenViews(views: ModelViews): ModelView[] {
  const usual: ViewName[] = ['front-left', 'back-right'];
  const chosen = usual.map((name) => views.from(name));
  const others: ViewName[] = ['above', 'below', 'front-right', 'back-left'];
  const shown = (view: ModelView, piece: number): boolean =>
    view.shares[piece]! > leastShare * view.total;
  const hidden = new Set(
    [...views.result.pieces.keys()].filter((piece) => !chosen.some((view) => shown(view, piece))),
  );
  while (chosen.length < 4 && hidden.size > 0) {
    const gains = others.map((name) => {
      const view = views.from(name);
      return { view, name, gain: [...hidden].filter((piece) => shown(view, piece)) };
    });
    const best = gains.reduce((a, b) => (b.gain.length > a.gain.length ? b : a));
    if (best.gain.length === 0) break;
    chosen.push(best.view);
    for (const piece of best.gain) hidden.delete(piece);
    others.splice(others.indexOf(best.name), 1);
  }
  return chosen;
}

function drawLetters(page: Page, { views }: CoverInput, view: ModelView, frame: Frame): void {
  const { pieces } = views.result;
  if (pieces.length < 2) return;
  const names = pieces.map(({ name }) => shortened(name, sizes.letter, longestName));
  const fit = fitOf(views, view.view, frame);
  const found = middlesOf(views, view.areas, fit, frame);
  for (const piece of [...found.keys()]) {
    if (view.shares[piece]! <= leastShare * view.total) found.delete(piece);
  }
  const side = sideRoom(views);
  const drop = (capHeight * sizes.letter) / 2;
  for (const { anchor, at, text } of placeLetters(found, names, {
    frame,
    side,
    size: sizes.letter,
  })) {
    page.text(text, [at[0], at[1] - drop], sizes.letter, 'middle');
    if (!anchor) continue;
    const half = widthAtMost(text, sizes.letter) / 2 + 0.4;
    const end: Point = [at[0] + (anchor[0] < at[0] ? -half : half), at[1]];
    page.stroke(thin, [end, anchor]);
    page.draw([{ kind: 'area', colour: thin.colour, walks: [dotAround(anchor, 0.45)] }]);
  }
}

/** Room for names at each side of a picture. */
function sideRoom({ result: { pieces } }: ModelViews): number {
  if (pieces.length < 2) return 0;
  const widths = pieces.map(({ name }) => widthAtMost(name, sizes.letter));
  return Math.min(Math.max(...widths), longestName) + 3;
}

function drawView(page: Page, input: CoverInput, modelView: ModelView, box: Frame): void {
  const { views, flatFold, words } = input;
  const side = sideRoom(views);
  const frame: Frame = {
    left: box.left + side,
    bottom: box.bottom + captionHeight,
    width: box.width - 2 * side,
    height: box.height - captionHeight,
  };
  const { areas, scene, view } = modelView;
  const colourOf = (piece: number): readonly number[] => pieceRgb(views, piece);
  const fit = fitOf(views, view, frame);
  const isThere = (): boolean => true;
  page.draw(drawModel({ views, view, scene, areas, isThere, colourOf, flatFold, fit }));
  drawLetters(page, input, modelView, frame);
  const [, low] = reachOf(views, view, frame);
  const middle: Point = [box.left + box.width / 2, low - captionHeight];
  page.text(words.view({ name: modelView.name }), middle, sizes.small, 'middle');
}

/** Width over height of the model in a view. */
function aspectOf(views: ModelViews, { view }: ModelView): number {
  const unit: Frame = { left: 0, bottom: 0, width: 1, height: 1 };
  const [left, bottom, right, top] = reachOf(views, view, unit);
  return (right - left) / Math.max(top - bottom, 1e-9);
}

/** So many columns that the smallest picture is as large as it can be. */
function columnsFor(views: ModelViews, chosen: readonly ModelView[], area: Frame): number {
  const aspects = chosen.map((view) => aspectOf(views, view));
  const heightOf = (columns: number): number => {
    const rows = Math.ceil(chosen.length / columns);
    const width = (area.width - (columns - 1) * gap) / columns - 2 * sideRoom(views);
    const height = (area.height - (rows - 1) * gap) / rows - captionHeight;
    return Math.min(...aspects.map((aspect) => Math.min(height, width / aspect)));
  };
  const counts = chosen.map((_, i) => i + 1);
  return counts.reduce((a, b) => (heightOf(b) > heightOf(a) ? b : a));
}

function drawViews(page: Page, input: CoverInput, area: Frame): void {
  const chosen = chosenViews(input.views);
  const columns = columnsFor(input.views, chosen, area);
  const rows = Math.ceil(chosen.length / columns);
  const width = (area.width - (columns - 1) * gap) / columns;
  const height = (area.height - (rows - 1) * gap) / rows;
  chosen.forEach((view, i) => {
    const [column, row] = [i % columns, Math.floor(i / columns)];
    drawView(page, input, view, {
      left: area.left + column * (width + gap),
      bottom: area.bottom + area.height - height - row * (height + gap),
      width,
      height,
    });
  });
}

/** Millimetres as people read them: to a tenth where they are few. */
function length(mm: number): string {
  return String(Number(mm.toFixed(mm < 10 ? 1 : 0)));
}

function factsOf({ plan, result, words }: CoverInput): [label: string, value: string][] {
  const { model, pieces, sheets } = result;
  const [width, height, depth] = extentsOf(model.vertices).map(length);
  const time = buildingTime(result, plan.steps);
  const sum = (kind: 'mountains' | 'valleys'): number =>
    plan.folds.reduce((all, folds) => all + folds[kind], 0);
  const paper = { width: length(sheets[0]!.width), height: length(sheets[0]!.height) };
  return [
    [words.sizeLabel(), words.size({ width: width!, height: height!, depth: depth! })],
    [words.amountLabel(), words.amount({ pieces: pieces.length, sheets: sheets.length, ...paper })],
    [words.foldsLabel(), words.folds({ mountains: sum('mountains'), valleys: sum('valleys') })],
    [words.seamsLabel(), words.seams({ seams: plan.seams })],
    [words.gluedLabel(), words.duration({ seconds: time.glued })],
    [words.tapedLabel(), words.duration({ seconds: time.taped })],
  ];
}

/** A part of the foot of the page: how high it is, and how it is drawn from its upper left. */
interface Block {
  height: number;
  draw: (page: Page, left: number, top: number) => void;
}

const lineHeight = 4.2;
const rowGap = 1.4;

/** Lines one below the other. */
function writeLines(page: Page, lines: readonly string[], left: number, top: number): void {
  lines.forEach((line, i) => {
    page.text(line, [left, top - i * lineHeight - capHeight * sizes.text], sizes.text);
  });
}

/** Blocks below each other. */
function stacked(blocks: readonly Block[]): Block {
  const height = blocks.reduce((sum, block) => sum + block.height + rowGap, -rowGap);
  return {
    height,
    draw: (page, left, top) => {
      let y = top;
      for (const block of blocks) {
        block.draw(page, left, y);
        y -= block.height + rowGap;
      }
    },
  };
}

/** A text with something in front of it. */
function labelled(
  start: number,
  text: string,
  room: number,
  draw: Block['draw'],
  least = 1,
): Block {
  const lines = wrapped(text, sizes.text, room - start);
  return {
    height: Math.max(lines.length, least) * lineHeight,
    draw: (page, left, top) => {
      draw(page, left, top);
      writeLines(page, lines, left + start, top);
    },
  };
}

function factsBlock(input: CoverInput, room: number): Block {
  const facts = factsOf(input);
  const start = Math.max(...facts.map(([label]) => widthAtMost(label, sizes.text))) + 2;
  return stacked(
    facts.map(([label, value]) =>
      labelled(start, value, room, (page, left, top) => writeLines(page, [label], left, top)),
    ),
  );
}

/** A fold seen from its end, and the line that it is drawn as. */
function drawFoldSample(page: Page, look: Look, kind: 'mountain' | 'valley', at: Point): void {
  const [x, y] = at;
  const [ends, middle] = kind === 'mountain' ? [y - 4, y - 0.4] : [y - 0.4, y - 4];
  page.stroke({ width: 0.5, colour: '#222222', dash: [] }, [
    [x, ends],
    [x + 4.5, middle],
    [x + 9, ends],
  ]);
  page.stroke(look.lines[kind], [
    [x + 12, y - 2.2],
    [x + 24, y - 2.2],
  ]);
}

/** Names of pieces with valleys beyond this number are not listed: the list of pieces tells. */
const mostNames = 12;

function foldsBlock({ look, plan, result, words }: CoverInput, room: number): Block {
  const samples = (['mountain', 'valley'] as const).map((kind) =>
    labelled(
      27,
      words[kind](),
      room,
      (page, left, top) => drawFoldSample(page, look, kind, [left, top]),
      2,
    ),
  );
  const names = result.pieces
    .filter((_, piece) => plan.folds[piece]!.valleys > 0)
    .map(({ name }) => name);
  const told = words.valleyPieces({
    names: names.length <= mostNames ? names : [],
    pieces: names.length,
    all: names.length === result.pieces.length,
  });
  return stacked([...samples, labelled(0, told, room, () => undefined)]);
}

function howBlock({ words }: CoverInput, room: number): Block {
  const sentences = words
    .how()
    .map((sentence, i) =>
      labelled(6, sentence, room, (page, left, top) => writeLines(page, [`${i + 1}.`], left, top)),
    );
  const title: Block = {
    height: 6,
    draw: (page, left, top) => {
      page.text(words.howTitle(), [left, top - capHeight * sizes.subtitle], sizes.subtitle);
    },
  };
  return stacked([title, ...sentences]);
}

/** Fills a page. */
export function drawCover(page: Page, input: CoverInput): void {
  const { margin, room } = page;
  const top = page.height - margin;
  const name = shortened(input.title, sizes.title, room);
  page.text(name, [margin, top - capHeight * sizes.title], sizes.title);
  const line = top - 11;
  page.stroke({ width: 0.3, colour: '#333333', dash: [] }, [
    [margin, line],
    [margin + room, line],
  ]);
  const column = (room - gap) / 2;
  const [facts, folds, how] = [
    factsBlock(input, column),
    foldsBlock(input, column),
    howBlock(input, room),
  ];
  const upper = Math.max(facts.height, folds.height);
  // The note at the foot of the page stays free.
  const foot = margin + 6 + how.height + gap + upper;
  facts.draw(page, margin, foot);
  folds.draw(page, margin + column + gap, foot);
  how.draw(page, margin, foot - upper - gap);
  drawViews(page, input, {
    left: margin,
    bottom: foot + gap,
    width: room,
    height: line - foot - 2 * gap,
  });
}
