/** What PDF pages are told to paint lines and areas. */
import {
  closePath,
  fill,
  fillAndStroke,
  lineTo,
  moveTo,
  popGraphicsState,
  pushGraphicsState,
  rgb,
  setDashPattern,
  setFillingColor,
  setLineCap,
  setLineJoin,
  setLineWidth,
  setStrokingColor,
  stroke,
  type PDFOperator,
} from 'pdf-lib';
import type { LineStyle } from '../model/print-options.js';
import { edgeStyle, type PictureShape } from './picture-shape.js';
import type { Point } from './point.js';

/** A length in points; a ten-thousandth of a point is far below what any printer resolves. */
export function points(millimetres: number): number {
  return Math.round((millimetres * 72e4) / 25.4) / 1e4;
}

/** Six hexadecimal digits after '#' as a colour. */
export function colour(hex: string): ReturnType<typeof rgb> {
  const channel = (at: number): number => Number.parseInt(hex.slice(at, at + 2), 16) / 255;
  return rgb(channel(1), channel(3), channel(5));
}

function path(walk: readonly Point[], closed: boolean): PDFOperator[] {
  const steps = walk.map(([x, y], i) => (i === 0 ? moveTo : lineTo)(points(x), points(y)));
  return closed ? [...steps, closePath()] : steps;
}

/** @param isSharp whether lines end where they end, and have corners; else both are rounded */
export function paintLines(
  style: LineStyle,
  walks: readonly Point[][],
  closed: boolean,
  isSharp = false,
): PDFOperator[] {
  if (walks.length === 0) return [];
  return [
    pushGraphicsState(),
    setStrokingColor(colour(style.colour)),
    setLineWidth(points(style.width)),
    setLineJoin(isSharp ? 0 : 1),
    setLineCap(isSharp || style.dash.length > 0 ? 0 : 1),
    setDashPattern(style.dash.map(points), 0),
    ...walks.flatMap((walk) => [...path(walk, closed), stroke()]),
    popGraphicsState(),
  ];
}

/** @param hex their colour, or 'none' */
export function paintAreas(hex: string, walks: readonly Point[][]): PDFOperator[] {
  if (hex === 'none' || walks.length === 0) return [];
  return [
    pushGraphicsState(),
    setFillingColor(colour(hex)),
    ...walks.flatMap((walk) => [...path(walk, true), fill()]),
    popGraphicsState(),
  ];
}

/** Areas in one go, or thin white lines would show between neighbours. */
export function paintShape(shape: PictureShape): PDFOperator[] {
  if (shape.kind === 'line') return paintLines(shape.style, shape.walks, shape.closed);
  return [
    pushGraphicsState(),
    setFillingColor(colour(shape.colour)),
    setStrokingColor(colour(shape.colour)),
    setLineWidth(points(edgeStyle(shape.colour).width)),
    setLineJoin(1),
    ...shape.walks.flatMap((walk) => path(walk, true)),
    fillAndStroke(),
    popGraphicsState(),
  ];
}
