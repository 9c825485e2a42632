/** Pictures of the model: shaded faces in the colours of their pieces, and lines around them. */
import { partRgb } from '../model/part-colours.js';
import type { LineStyle } from '../model/print-options.js';
import { dot, vectorAt, type Vector } from '../model/vector.js';
import { boxOf } from './polygon.js';
import type { Scene, VisibleArea } from './hidden-surfaces.js';
import type { ModelEdge, ModelViews } from './model-views.js';
import { dotAround, type Frame, type PictureShape } from './picture-shape.js';
import type { Point } from './point.js';
import type { View } from './view-direction.js';

/** Red, green and blue, 0 to 255. */
type Rgb = readonly number[];

/** What a picture shows of the model. */
export interface PictureWish {
  views: ModelViews;
  view: View;
  scene: Scene;
  areas: readonly VisibleArea[];
  /** Faces that are there. */
  isThere: (face: number) => boolean;
  colourOf: (piece: number) => Rgb;
  /** Folds flatter than this many degrees show no line; none does without it. */
  flatFold?: number;
  fit: Fit;
}

/** Takes points of a view into a frame, as large as they go, in its middle. */
export type Fit = (point: Point) => Point;

export const paperGrey: Rgb = [226, 226, 226];
const innerSide: Rgb = [246, 244, 240];

/** Colour of a piece: that of its part in the studio. */
export function pieceRgb({ result }: ModelViews, piece: number): Rgb {
  return partRgb(result.pieces[piece]!.part);
}

// Light comes over the left shoulder of who looks: right, up and towards them.
const light: Vector = [-0.37, 0.56, 0.74];
/** What is left of a colour where no light falls, and steps to full light: fewer colours are smaller files. */
const [shade, steps] = [0.66, 12];

const lines: Readonly<Record<'outline' | 'piece' | 'crease', LineStyle>> = {
  outline: { width: 0.22, colour: '#222222', dash: [] },
  piece: { width: 0.22, colour: '#222222', dash: [] },
  crease: { width: 0.07, colour: '#777777', dash: [] },
};

export function hexOf(rgb: Rgb): string {
  return `#${rgb.map((value) => Math.round(value).toString(16).padStart(2, '0')).join('')}`;
}

/** A hundredth of a millimetre is finer than any printer; fewer digits are smaller files. */
function rounded(value: number): number {
  return Math.round(100 * value) / 100;
}

/** What of a frame the whole model covers. */
export function reachOf(views: ModelViews, view: View, frame: Frame): Box {
  const fit = fitOf(views, view, frame);
  return boxOf(allPoints(views, view).map(fit));
}

type Box = ReturnType<typeof boxOf>;

function pointOf({ result: { model } }: ModelViews, { right, up }: View, vertex: number): Point {
  const corner = vectorAt(model.vertices, vertex);
  return [dot(corner, right), dot(corner, up)];
}

function allPoints(views: ModelViews, view: View): Point[] {
  const count = views.result.model.vertices.length / 3;
  return Array.from({ length: count }, (_, vertex) => pointOf(views, view, vertex));
}

/** Of a box in a frame; an empty box has any. */
function scaleOf([left, bottom, right, top]: Box, frame: Frame): number {
  return Math.min(
    frame.width / Math.max(right - left, 1e-9),
    frame.height / Math.max(top - bottom, 1e-9),
  );
}

/** How the whole model lies in a frame; all pictures of one size and view lie alike. */
export function fitOf(views: ModelViews, view: View, frame: Frame): Fit {
  const box = boxOf(allPoints(views, view));
  return fitted(box, scaleOf(box, frame), frame);
}

/** Over the scale of the whole model: larger a part of it would seem to be another thing. */
const mostEnlarged = 2.5;

/** How some faces lie in a frame: as large as they go, in its middle. */
export function fitOfFaces(
  views: ModelViews,
  view: View,
  frame: Frame,
  faces: readonly number[],
): Fit {
  const corners = faces.flatMap((face) => [3 * face, 3 * face + 1, 3 * face + 2]);
  const points = corners.map((at) => pointOf(views, view, views.result.model.faces[at]!));
  const whole = scaleOf(boxOf(allPoints(views, view)), frame);
  const box = boxOf(points);
  return fitted(box, Math.min(scaleOf(box, frame), mostEnlarged * whole), frame);
}

function fitted([left, bottom, right, top]: Box, scale: number, frame: Frame): Fit {
  const x0 = frame.left + frame.width / 2 - (scale * (left + right)) / 2;
  const y0 = frame.bottom + frame.height / 2 - (scale * (bottom + top)) / 2;
  return ([x, y]) => [rounded(x0 + scale * x), rounded(y0 + scale * y)];
}

/** A piece that shows less than this across is hard to find; mm on paper. */
const smallAcross = 5;
const ringStyle: LineStyle = { width: 0.4, colour: '#c02020', dash: [] };

/** A ring around a piece that is hard to find in a picture; nothing around others. */
export function ringAround(
  views: ModelViews,
  areas: readonly VisibleArea[],
  piece: number,
  fit: Fit,
): PictureShape[] {
  const points = areas
    .filter(({ face }) => views.pieceOf[face] === piece)
    .flatMap(({ walk }) => walk.map(fit));
  if (points.length === 0) return [];
  const [left, bottom, right, top] = boxOf(points);
  const across = Math.max(right - left, top - bottom);
  if (across > smallAcross) return [];
  const walk = dotAround([(left + right) / 2, (bottom + top) / 2], across / 2 + 2);
  return [{ kind: 'line', style: ringStyle, walks: [walk], closed: true }];
}

/** The colour of a face under the light. */
function shaded(rgb: Rgb, normal: Vector, { right, up, towards }: View): string {
  const seen: Vector = [dot(normal, right), dot(normal, up), dot(normal, towards)];
  const bright = Math.round(steps * Math.max(0, dot(seen, light))) / steps;
  return hexOf(rgb.map((value) => value * (shade + (1 - shade) * bright)));
}

function fills({ areas, colourOf, fit, view, views }: PictureWish): PictureShape[] {
  const byColour = new Map<string, Point[][]>();
  for (const { face, isBack, walk } of areas) {
    const normal = views.normals[face]!;
    const colour = isBack
      ? shaded(innerSide, [-normal[0], -normal[1], -normal[2]], view)
      : shaded(colourOf(views.pieceOf[face]!), normal, view);
    const walks = byColour.get(colour);
    if (walks) walks.push(walk.map(fit));
    else byColour.set(colour, [walk.map(fit)]);
  }
  return [...byColour].map(([colour, walks]) => ({ kind: 'area', colour, walks }));
}

/** What an edge shows as, of the faces beside it that are there; null for none. */
function kindOf(
  faces: readonly number[],
  { flatFold, scene, views }: PictureWish,
): keyof typeof lines | null {
  if (faces.length === 0) return null;
  const [a, b] = faces;
  if (b === undefined || faces.length > 2) return 'outline';
  const fronts = [a!, b].filter((face) => scene.showsFront(face)).length;
  if (fronts === 1) return 'outline';
  if (views.pieceOf[a!] !== views.pieceOf[b]) return 'piece';
  if (flatFold === undefined) return null;
  const cosine = dot(views.normals[a!]!, views.normals[b]!);
  return cosine < Math.cos((flatFold * Math.PI) / 180) ? 'crease' : null;
}

function strokes(wish: PictureWish): PictureShape[] {
  const { fit, isThere, scene, views } = wish;
  const byKind = { crease: [], piece: [], outline: [] } as Record<keyof typeof lines, ModelEdge[]>;
  for (const edge of views.edges) {
    const kind = kindOf(edge.faces.filter(isThere), wish);
    if (kind) byKind[kind].push(edge);
  }
  return (['crease', 'piece', 'outline'] as const).flatMap((kind): PictureShape[] => {
    const seen = scene.lines(byKind[kind].map(({ ends }) => ends));
    if (seen.length === 0) return [];
    const walks = seen.map(({ segment }) => segment.map(fit));
    return [{ kind: 'line', style: lines[kind], walks, closed: false }];
  });
}

/** A picture of what is there. */
export function drawModel(wish: PictureWish): PictureShape[] {
  return [...fills(wish), ...strokes(wish)];
}
