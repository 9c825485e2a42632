/** The steps, each with the net of its piece, the model as it is then, and what to do. */
import type { PrintOptions } from '../model/print-options.js';
import type { BuildingWords } from '../words/building.js';
import {
  edgeList,
  numberOf,
  partnerOf,
  sideOn,
  type BuildingPlan,
  type BuildingStep,
} from './building-plan.js';
import type { Border } from '../model/border-order.js';
import { modelVertices } from '../model/model-vertices.js';
import type { ModelLine } from './hidden-surfaces.js';
import { drawModel, fitOfFaces, paperGrey, pieceRgb, ringAround } from './model-picture.js';
import type { ModelViews } from './model-views.js';
import { wrapped, type Page } from './page-layout.js';
import type { Frame, PictureShape } from './picture-shape.js';
import type { Point } from './point.js';
import { numberRuns } from './seam-numbers.js';
import {
  borderSample,
  drawStepNet,
  endsOf,
  markShape,
  valleyStyle,
  type StepMark,
} from './step-net.js';
import { capHeight, shortened, widthAtMost } from './text-line.js';
import type { ViewName } from './view-direction.js';

const sizes = { heading: 6, name: 4.4, text: 2.8 } as const;
const pictureHeight = 46;
const pictureWidth = 48;
const gap = 5;
const lineHeight = 4.1;
const thin = { width: 0.15, colour: '#aaaaaa', dash: [] };

export interface StepsInput {
  views: ModelViews;
  plan: BuildingPlan;
  options: PrintOptions;
  /** Whether steps show the model as it grows. */
  hasPictures: boolean;
  words: BuildingWords;
}

/** What of a border of the model is seen in a picture: the middle of its longest part. */
function seenMiddle(
  views: ModelViews,
  scene: ReturnType<ModelViews['partly']>['scene'],
  { edge, piece }: { edge: number; piece: number },
): Point | null {
  const line = modelLineOf(views, piece, edge);
  const parts = scene.lines([line]).map(({ segment }) => segment);
  const length = ([[x, y], [u, v]]: [Point, Point]): number => (u - x) ** 2 + (v - y) ** 2;
  const [longest] = parts.sort((a, b) => length(b) - length(a));
  if (!longest) return null;
  const [[x, y], [u, v]] = longest;
  return [(x + u) / 2, (y + v) / 2];
}

/** The vertices of the model that an edge of a piece runs between. */
function modelLineOf({ result }: ModelViews, at: number, edge: number): ModelLine {
  const piece = result.pieces[at]!;
  const vertices = modelVertices(piece, result.model);
  return [vertices[piece.edges[2 * edge]!]!, vertices[piece.edges[2 * edge + 1]!]!];
}

/** The model after a step: what is new in its colour, all else in grey. */
function drawGrown(
  { views }: StepsInput,
  step: BuildingStep,
  built: ReadonlySet<number>,
  name: ViewName,
  frame: Frame,
): PictureShape[] {
  const { view } = views.from(name);
  const { faces, scene } = views.partly(view, (piece) => built.has(piece));
  const there = new Set(faces);
  const colourOf = (piece: number): readonly number[] =>
    piece === step.piece ? pieceRgb(views, piece) : paperGrey;
  const isThere = (face: number): boolean => there.has(face);
  const areas = scene.areas();
  const fit = fitOfFaces(views, view, frame, faces);
  const shapes = [
    ...drawModel({ views, view, scene, areas, isThere, colourOf, fit }),
    ...ringAround(views, areas, step.piece, fit),
  ];
  const mark = (kind: StepMark, border?: Border): PictureShape[] => {
    const at = border && seenMiddle(views, scene, sideOn(border, step.piece));
    return at ? markShape(kind, fit(at)) : [];
  };
  const gluing = endsOf(step.glued);
  return [...shapes, ...mark('glue-last', gluing.last), ...mark('glue-first', gluing.first)];
}

/** Numbers of borders, piece by piece in the order of gluing. */
function groupsOf(
  { plan, views }: StepsInput,
  step: BuildingStep,
): { name: string; runs: string[] }[] {
  const { result } = views;
  const groups: { partner: number; numbers: string[] }[] = [];
  for (const border of step.glued) {
    const partner = partnerOf(border, step.piece);
    const number = numberOf(result, plan, border);
    let group = groups.at(-1);
    if (group?.partner !== partner) groups.push((group = { partner, numbers: [] }));
    if (number !== undefined) group.numbers.push(number);
  }
  return groups.map(({ partner, numbers }) => ({
    name: result.pieces[partner]!.name,
    runs: numberRuns(numbers),
  }));
}

/** What to do in a step, in sentences. */
export function stepSentences(input: StepsInput, step: BuildingStep, rank: number): string[] {
  const { plan, views, words } = input;
  const { result } = views;
  const sentences = [
    words.fold({ folds: step.folds, crease: step.crease, turn: step.turn.length }),
  ];
  if (step.closed.length > 0) sentences.push(words.close(edgeList(result, plan, step.closed)));
  if (step.glued.length > 0) {
    const groups = groupsOf(input, step);
    sentences.push(words.glue({ ...edgeList(result, plan, step.glued), groups }));
  } else if (rank > 0) {
    sentences.push(words.apart());
  }
  if (rank === plan.steps.length - 1) {
    const last = step.glued.at(-1) ?? step.closed.at(-1);
    const number = last && numberOf(result, plan, last);
    sentences.push(words.finish({ last: number ?? null }));
  }
  return sentences;
}

/** What the marks in the pictures mean, in one row. */
function drawMarks(page: Page, baseline: number, words: BuildingWords): void {
  const marks = ['close-first', 'close-last', 'glue-first', 'glue-last'] as const;
  let left = page.margin;
  const middle = baseline + (capHeight * sizes.text) / 2;
  const told = (mark: Parameters<BuildingWords['marks']>[0]['mark'], width: number): void => {
    const text = words.marks({ mark });
    page.text(text, [left + width, baseline], sizes.text);
    left += width + 0.8 * widthAtMost(text, sizes.text) + 4;
  };
  for (const mark of marks) {
    page.draw(markShape(mark, [left + 1.5, middle]));
    told(mark, 4.5);
  }
  page.stroke(valleyStyle, [
    [left, middle],
    [left + 5, middle],
  ]);
  told('valley', 7);
  page.stroke(borderSample, [
    [left, middle],
    [left + 5, middle],
  ]);
  told('border', 7);
}

/** Pages with a heading and room below; as many as it takes. */
class Flow {
  page: Page;
  /** Down to here the page is full. */
  y = 0;

  constructor(
    private readonly newPage: () => Page,
    private readonly words: BuildingWords,
  ) {
    this.page = this.begin();
  }

  /** Goes on where there is so much room, on another page if need be. */
  need(height: number): void {
    // The note at the foot of the page stays free.
    if (this.y - height < this.page.margin + 5) this.page = this.begin();
  }

  private begin(): Page {
    const page = this.newPage();
    const top = page.height - page.margin;
    page.text(
      this.words.stepsTitle(),
      [page.margin, top - capHeight * sizes.heading],
      sizes.heading,
    );
    drawMarks(page, top - 11.5, this.words);
    this.y = top - 15;
    return page;
  }
}

function drawStep(
  flow: Flow,
  input: StepsInput,
  step: BuildingStep,
  rank: number,
  grown: (frame: Frame) => PictureShape[],
): void {
  const { words } = input;
  const { name, sheet } = input.views.result.pieces[step.piece]!;
  flow.need(pictureHeight + 4);
  const { page } = flow;
  const { margin, room } = page;
  page.stroke(thin, [
    [margin, flow.y],
    [margin + room, flow.y],
  ]);
  const bottom = flow.y - pictureHeight - 2;
  const net: Frame = {
    left: margin + 1,
    bottom: bottom + 1,
    width: pictureWidth - 2,
    height: pictureHeight - 2,
  };
  page.draw(drawStepNet(input.views, step, input.options, net));
  page.draw(grown({ ...net, left: net.left + pictureWidth + gap }));
  const left = margin + 2 * (pictureWidth + gap);
  const width = margin + room - left;
  const title = shortened(words.stepTitle({ step: rank + 1, name }), sizes.name, width);
  page.text(title, [left, flow.y - 3 - capHeight * sizes.name], sizes.name);
  page.text(words.sheet({ sheet: sheet + 1 }), [left, flow.y - 11.5], sizes.text);
  const lines = stepSentences(input, step, rank).flatMap((sentence) => [
    ...wrapped(sentence, sizes.text, width),
    '',
  ]);
  const first = flow.y - 17.5;
  flow.y = first;
  for (const line of lines.slice(0, -1)) {
    // A long list of numbers goes on overleaf.
    flow.need(lineHeight);
    if (line !== '') flow.page.text(line, [left, flow.y], sizes.text);
    flow.y -= line === '' ? 0.4 * lineHeight : lineHeight;
  }
  if (flow.page === page) flow.y = Math.min(flow.y, bottom);
  flow.y -= 1;
}

/**
 * As many pages as it takes.
 *
 * @param newPage begins another one
 */
export function drawSteps(newPage: () => Page, input: StepsInput): void {
  const flow = new Flow(newPage, input.words);
  const built = new Set<number>();
  let usual: ViewName = 'front-left';
  for (const [rank, step] of input.plan.steps.entries()) {
    built.add(step.piece);
    if (input.hasPictures) usual = input.views.bestFor(step.piece, usual).name;
    const name = usual;
    drawStep(flow, input, step, rank, (frame) =>
      input.hasPictures ? drawGrown(input, step, built, name, frame) : [],
    );
  }
}
