import type { JobResult, Piece, PieceLabel, Strip } from '../model/job.js';
import type { PrintOptions } from '../model/print-options.js';
import { flapShape, type FlapShape } from './flap-shape.js';
import type { FlapCorners } from './flap-corners.js';
import type { GroundShape } from './ground-shape.js';
import { groundOf } from './piece-ground.js';
import { bareFlap } from './texture/flap-bleed.js';
import { tellAngles, type AngledFold } from './fold-angles.js';
import type { SheetFrame } from './sheet-frame.js';
import type { PictureShape } from './picture-shape.js';
import type { Point, Segment } from './point.js';
import { sidesOf } from './polygon.js';
import type { PieceImage } from './texture/piece-images.js';
import { centredLine, underlineOf, type TextLine } from './text-line.js';

/**
 * The lines of one piece, or of a loose strip, where they lie on the sheet; mm, y up, from the
 * sheet's lower left.
 */
export interface PieceDrawing {
  /** The piece's name; of a strip `strip-` and the id of its seam. */
  letter: string;
  /** Closed boundary walks around faces and flaps; slits are walked there and back. */
  cuts: Point[][];
  mountains: Segment[];
  valleys: Segment[];
  /** Lines from numbers to their edges, and strokes across edges to be joined by tape. */
  guides: Segment[];
  /** Whether there are such marks. */
  hasTape: boolean;
  /** Outlines of its flaps, without what is coloured as the piece is. */
  flaps: Point[][];
  /** What it is coloured with, from below. */
  ground: GroundShape[];
  /** Its name, the ids of its cut edges, and the angles of its folds. */
  texts: TextLine[];
}

/** Marks by which a machine finds a printed sheet, in black. */
export interface RegistrationMarks {
  /** Filled. */
  square: Point[];
  /** Lines with a corner in their middle. */
  corners: Point[][];
  /** Of the lines; mm. */
  width: number;
}

/** Everything that is drawn on one sheet, before a format gives it its syntax. */
export interface SheetDrawing {
  width: number;
  height: number;
  pieces: PieceDrawing[];
  frame: SheetFrame;
  /** Below all else, on pages that tell how to build the model. */
  picture?: PictureShape[];
  /** By which a machine finds the sheet, if it cuts what was printed before. */
  registration?: RegistrationMarks;
}

type At = (vertex: number) => Point;

function areSame([x, y]: Point, [u, v]: Point): boolean {
  // A tenth of the last decimal that is written.
  return Math.abs(x - u) < 1e-5 && Math.abs(y - v) < 1e-5;
}

/** The closed walks along the cuts, around the flaps. */
function drawCuts(piece: Piece, shapes: readonly FlapShape[], at: At): Point[][] {
  const { edges, bases } = piece.flaps;
  const flapAt = new Map<number, number>(); // by the vertex that its base starts from
  edges.forEach((_, flap) => flapAt.set(bases[2 * flap]!, flap));
  return piece.outlines.map((outline) => {
    // A walk that begins within a base would cut it in two.
    const inner = new Set(edges.length > 0 ? insideBases(outline, piece) : []);
    const walk: Point[] = [];
    for (const vertex of outline) {
      if (inner.has(vertex)) continue;
      walk.push(at(vertex));
      const flap = flapAt.get(vertex);
      if (flap !== undefined) walk.push(...shapes[flap]!.cut);
    }
    return walk.filter((point, i) => !areSame(point, walk[(i + 1) % walk.length]!));
  });
}

/** The vertices of an outline that lie between the ends of a flap's base. */
function* insideBases(outline: Int32Array, { flaps }: Piece): Generator<number> {
  const place = new Map(Array.from(outline, (vertex, i) => [vertex, i]));
  for (let flap = 0; flap < flaps.edges.length; ++flap) {
    const [from, to] = [place.get(flaps.bases[2 * flap]!), place.get(flaps.bases[2 * flap + 1]!)];
    if (from === undefined || to === undefined) continue;
    for (let i = (from + 1) % outline.length; i !== to; i = (i + 1) % outline.length) {
      yield outline[i]!;
    }
  }
}

/** The folds of one sign between faces. */
function drawFolds(piece: Piece, letter: 'M' | 'V', flatFold: number, at: At): Segment[] {
  const segments: Segment[] = [];
  for (let edge = 0; edge < piece.assignments.length; ++edge) {
    if (piece.assignments[edge] !== letter) continue;
    if (Math.abs(piece.foldAngles[edge]!) < flatFold) continue;
    segments.push([at(piece.edges[2 * edge]!), at(piece.edges[2 * edge + 1]!)]);
  }
  return segments;
}

/** The folds of flaps of one sign, however flat: they show where the neighbour's edge comes to lie. */
function drawFlapFolds(piece: Piece, letter: 'M' | 'V', shapes: readonly FlapShape[]): Segment[] {
  return shapes
    .filter((_, flap) => (piece.flaps.angles[flap]! > 0 ? 'V' : 'M') === letter)
    .map(({ fold }) => fold);
}

/** The folds between faces that are drawn, with their angles. */
function angledFolds(piece: Piece, flatFold: number, at: At): AngledFold[] {
  const folds: AngledFold[] = [];
  piece.foldAngles.forEach((angle, edge) => {
    if (!'MV'.includes(piece.assignments[edge]!) || Math.abs(angle) < flatFold) return;
    folds.push({ line: [at(piece.edges[2 * edge]!), at(piece.edges[2 * edge + 1]!)], angle });
  });
  return folds;
}

/** Points of pairs of coordinates, moved. */
function pointsOf(coordinates: Float64Array, dx = 0, dy = 0): Point[] {
  return Array.from({ length: coordinates.length / 2 }, (_, i): Point => [
    coordinates[2 * i]! + dx,
    coordinates[2 * i + 1]! + dy,
  ]);
}

function segmentsOf(coordinates: Float64Array, dx = 0, dy = 0): Segment[] {
  const points = pointsOf(coordinates, dx, dy);
  return Array.from({ length: points.length / 2 }, (_, i): Segment => [
    points[2 * i]!,
    points[2 * i + 1]!,
  ]);
}

function lineOf({ text, x, y, angle, size }: PieceLabel, dx = 0, dy = 0): TextLine {
  return centredLine({ text, x: x + dx, y: y + dy, angle, size });
}

const isOnPiece = ({ isBeside }: PieceLabel): boolean => isBeside !== true;

function drawGuides({ jointLines, labels, tapeMarks, x, y }: Piece): Segment[] {
  const leaders = labels
    .filter(isOnPiece)
    .flatMap(({ leader }) => (leader ? segmentsOf(leader, x, y) : []));
  return [...leaders, ...segmentsOf(tapeMarks, x, y), ...segmentsOf(jointLines, x, y)];
}

function drawStrip({ id, outline, fold, foldAngle, label }: Strip): PieceDrawing {
  const folds = segmentsOf(fold);
  const isValley = foldAngle > 0;
  return {
    letter: `strip-${id}`,
    cuts: [pointsOf(outline)],
    mountains: isValley ? [] : folds,
    valleys: isValley ? folds : [],
    guides: [],
    hasTape: false,
    flaps: [],
    ground: [],
    texts: [lineOf(label)],
  };
}

/** A piece before anything is coloured. */
interface BarePiece extends PieceDrawing {
  flaps: FlapCorners[];
}

/** The lines of one piece. */
export function drawPiece(
  piece: Piece,
  { flatFold, foldAngles, thickness }: PrintOptions,
): BarePiece {
  const at: At = (vertex) => [
    piece.x + piece.vertices[2 * vertex]!,
    piece.y + piece.vertices[2 * vertex + 1]!,
  ];
  const shapes = Array.from(piece.flaps.edges, (_, flap) => flapShape(piece, flap, thickness));
  const cuts = drawCuts(piece, shapes, at);
  const folds = (letter: 'M' | 'V'): Segment[] => [
    ...drawFolds(piece, letter, flatFold, at),
    ...drawFlapFolds(piece, letter, shapes),
  ];
  const [mountains, valleys] = [folds('M'), folds('V')];
  const guides = drawGuides(piece);
  const hasTape = piece.tapeMarks.length > 0;
  const texts = piece.labels.filter(isOnPiece).map((label) => lineOf(label, piece.x, piece.y));
  if (foldAngles) {
    const underlines = texts
      .filter(({ underlined }) => underlined)
      .map((text) => underlineOf(text).line);
    const lines = [...cuts.flatMap(sidesOf), ...mountains, ...valleys, ...guides, ...underlines];
    texts.push(...tellAngles(angledFolds(piece, flatFold, at), lines, texts));
  }
  return {
    letter: piece.name,
    cuts,
    mountains,
    valleys,
    guides,
    hasTape,
    flaps: shapes.map(({ corners }) => corners),
    ground: [],
    texts,
  };
}

/** The names of pieces on sheet number `sheet` that have no room on their piece, counted from 0. */
export function drawNamesBeside({ pieces }: JobResult, sheet: number): SheetFrame {
  const names: SheetFrame = { strokes: [], texts: [] };
  for (const piece of pieces) {
    if (piece.sheet !== sheet) continue;
    for (const label of piece.labels) {
      if (isOnPiece(label)) continue;
      names.texts.push(lineOf(label, piece.x, piece.y));
      if (label.leader) {
        names.strokes.push({ points: pointsOf(label.leader, piece.x, piece.y), closed: false });
      }
    }
  }
  return names;
}

/**
 * The pieces and loose strips on sheet number `sheet`, counted from 0.
 *
 * @param images of the pieces that are printed in the model's colours
 */
export function drawPieces(
  result: JobResult,
  sheet: number,
  options: PrintOptions,
  images: ReadonlyMap<Piece, PieceImage>,
): PieceDrawing[] {
  const draw = (piece: Piece): PieceDrawing => {
    const drawing = drawPiece(piece, options);
    const ground = groundOf(piece, images.get(piece) ?? null, options);
    if (ground.length === 0) return drawing;
    const flaps = drawing.flaps.flatMap((walk) => bareFlap(walk, options.flapBleed));
    return { ...drawing, ground, flaps };
  };
  const pieces = result.pieces.filter((piece) => piece.sheet === sheet);
  const strips = result.strips.filter((strip) => strip.sheet === sheet);
  return [...pieces.map(draw), ...strips.map(drawStrip)];
}
