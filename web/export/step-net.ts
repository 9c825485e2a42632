/** A small picture of a piece as it lies on its sheet, with what one step does at its edges. */
import type { Piece } from '../model/job.js';
import type { LineStyle, PrintOptions } from '../model/print-options.js';
import type { BuildingStep } from './building-plan.js';
import { partnerOf, sideOn } from './building-plan.js';
import type { Border } from '../model/border-order.js';
import { boxOf } from './polygon.js';
import { valleyColour } from './line-style.js';
import { hexOf, pieceRgb } from './model-picture.js';
import type { ModelViews } from './model-views.js';
import { dotAround, type Frame, type PictureShape } from './picture-shape.js';
import type { Point } from './point.js';
import { drawPiece } from './sheet-drawing.js';

export type StepMark = 'close-first' | 'close-last' | 'glue-first' | 'glue-last';

const dark = '#222222';
const styles = {
  cut: { width: 0.15, colour: dark, dash: [] },
  mountain: { width: 0.07, colour: '#888888', dash: [] },
  valley: { width: 0.45, colour: valleyColour, dash: [] },
  mark: { width: 0.35, colour: dark, dash: [] },
} as const satisfies Record<string, LineStyle>;

/** What folds and borders of another piece look like. */
export const valleyStyle: LineStyle = styles.valley;

const borderWidth = 1;

/** Of borders in general. */
export const borderSample: LineStyle = { width: borderWidth, colour: '#888888', dash: [] };
const markRadius = 1.1;

/** Darker than the faces of the piece, so that it shows as a line. */
export function borderStyle(views: ModelViews, piece: number): LineStyle {
  const colour = hexOf(pieceRgb(views, piece).map((value) => 0.7 * value));
  return { width: borderWidth, colour, dash: [] };
}

/** Round for edges of the same piece, square for those of others; full where one starts. */
export function markShape(mark: StepMark, at: Point): PictureShape[] {
  const [x, y] = at;
  const r = 0.9 * markRadius;
  const walk: Point[] = mark.startsWith('close')
    ? dotAround(at, markRadius)
    : [
        [x - r, y - r],
        [x + r, y - r],
        [x + r, y + r],
        [x - r, y + r],
      ];
  const colour = mark.endsWith('first') ? dark : '#ffffff';
  return [
    { kind: 'area', colour, walks: [walk] },
    { kind: 'line', style: styles.mark, walks: [walk], closed: true },
  ];
}

/** The first and the last border of a list, each once. */
export function endsOf(borders: readonly Border[]): { first?: Border; last?: Border } {
  const [first, last] = [borders[0], borders.at(-1)];
  return { ...(first && { first }), ...(last && last !== first && { last }) };
}

/** Small pieces are drawn larger than they are, but not so much that they seem to be others. */
const mostScale = 2;

/** Takes points of the sheet into the frame, true to their angles. */
function fitOf(walks: readonly Point[][], frame: Frame): (point: Point) => Point {
  const [left, bottom, right, top] = boxOf(walks.flat());
  const scale = Math.min(mostScale, frame.width / (right - left), frame.height / (top - bottom));
  const x0 = frame.left + frame.width / 2 - (scale * (left + right)) / 2;
  const y0 = frame.bottom + frame.height / 2 - (scale * (bottom + top)) / 2;
  return ([x, y]) => [x0 + scale * x, y0 + scale * y];
}

function sideOf({ edges, vertices, x, y }: Piece, edge: number): [Point, Point] {
  const at = (vertex: number): Point => [x + vertices[2 * vertex]!, y + vertices[2 * vertex + 1]!];
  return [at(edges[2 * edge]!), at(edges[2 * edge + 1]!)];
}

function middleOf([[x, y], [u, v]]: [Point, Point]): Point {
  return [(x + u) / 2, (y + v) / 2];
}

/** Folds between faces: those of flaps would hide what is glued to what. */
function valleysOf(piece: Piece, flatFold: number): [Point, Point][] {
  return [...piece.assignments].flatMap((kind, edge) =>
    kind === 'V' && piece.foldAngles[edge]! >= flatFold ? [sideOf(piece, edge)] : [],
  );
}

/** The marks of a step, where they lie on the sheet. */
function marksOf(piece: Piece, step: BuildingStep): { mark: StepMark; at: Point }[] {
  const at = (edge: number): Point => middleOf(sideOf(piece, edge));
  const closing = endsOf(step.closed);
  const gluing = endsOf(step.glued);
  const both = (mark: StepMark, border?: Border): { mark: StepMark; at: Point }[] =>
    (border ?? []).map(({ edge }) => ({ mark, at: at(edge) }));
  const one = (mark: StepMark, border?: Border): { mark: StepMark; at: Point }[] =>
    border ? [{ mark, at: at(sideOn(border, step.piece).edge) }] : [];
  return [
    ...both('close-last', closing.last),
    ...both('close-first', closing.first),
    ...one('glue-last', gluing.last),
    ...one('glue-first', gluing.first),
  ];
}

/** The net of a step in its frame. */
export function drawStepNet(
  views: ModelViews,
  step: BuildingStep,
  options: PrintOptions,
  frame: Frame,
): PictureShape[] {
  const piece = views.result.pieces[step.piece]!;
  const { cuts, mountains } = drawPiece(piece, { ...options, foldAngles: false, thickness: 0 });
  const valleys = valleysOf(piece, options.flatFold);
  const fit = fitOf(cuts, frame);
  const fitted = (walks: readonly Point[][]): Point[][] => walks.map((walk) => walk.map(fit));
  const colour = hexOf(pieceRgb(views, step.piece));
  const shapes: PictureShape[] = [
    { kind: 'area', colour, walks: fitted(cuts) },
    { kind: 'line', style: styles.mountain, walks: fitted(mountains), closed: false },
  ];
  for (const border of step.glued) {
    const { edge } = sideOn(border, step.piece);
    const style = borderStyle(views, partnerOf(border, step.piece));
    shapes.push({ kind: 'line', style, walks: fitted([sideOf(piece, edge)]), closed: false });
  }
  return [
    ...shapes,
    { kind: 'line', style: styles.cut, walks: fitted(cuts), closed: true },
    { kind: 'line', style: styles.valley, walks: fitted(valleys), closed: false },
    ...marksOf(piece, step).flatMap(({ at, mark }) => markShape(mark, fit(at))),
  ];
}
