/**
 * What of a model is seen from one side, as polygons and lines that hide nothing: exact, so that a picture
 * is right in whatever order it is drawn. Every face is cut by all faces in front of it; faces that run
 * through each other are cut where they cross.
 */
import type { Model } from '../model/job.js';
import { dot, vectorAt } from '../model/vector.js';
import { clipped, depthIn, remainder, sidesOf, type HalfPlane } from './convex.js';
import type { Point, Segment } from './point.js';
import { areaOf, boxOf } from './polygon.js';
import type { View } from './view-direction.js';

/** A part of a face that nothing hides. */
export interface VisibleArea {
  /** Of the model. */
  face: number;
  /** Convex, counter-clockwise; in mm of the model along the axes of the view. */
  walk: Point[];
  /** Whether it is the inner side of the paper. */
  isBack: boolean;
}

/** A part of an edge that nothing hides. */
export interface VisibleLine {
  /** Index in what was asked for. */
  line: number;
  segment: Segment;
}

/** Two vertices of the model. */
export type ModelLine = readonly [from: number, to: number];

/** Over the extent of the model: what is closer to each other lies in one place. */
const closeness = 1e-7;
/** Over its square: areas below are errors of rounding. */
const leastShare = 1e-11;
/**
 * Over the extent: what is seen of a line between others is left out below. Where a hidden line begins at a
 * corner in front, rounding shows that much of it; a picture of 10 cm shows it as 0.1 mm.
 */
const dotShare = 1e-3;

type Box = readonly [left: number, bottom: number, right: number, top: number];

/** A face as it is seen. */
interface Shadow {
  face: number;
  walk: Point[];
  isBack: boolean;
  sides: HalfPlane[];
  box: Box;
  /** Depth over the picture: larger is nearer to who looks. */
  depth: HalfPlane;
}

/** Shadows by where they are, in square cells. */
class Grid {
  private readonly cells = new Map<number, number[]>();
  private readonly stamps: Uint32Array;
  private turn = 0;

  constructor(
    shadows: readonly Shadow[],
    private readonly side: number,
    private readonly columns: number,
    private readonly corner: Point,
  ) {
    this.stamps = new Uint32Array(shadows.length);
    shadows.forEach(({ box }, index) => {
      this.forCells(box, (cell) => {
        const known = this.cells.get(cell);
        if (known) known.push(index);
        else this.cells.set(cell, [index]);
      });
    });
  }

  /** Shadows whose boxes may meet this one, ascending. */
  near(box: Box): number[] {
    ++this.turn;
    const found: number[] = [];
    this.forCells(box, (cell) => {
      for (const index of this.cells.get(cell) ?? []) {
        if (this.stamps[index] === this.turn) continue;
        this.stamps[index] = this.turn;
        found.push(index);
      }
    });
    return found.sort((a, b) => a - b);
  }

  private forCells([left, bottom, right, top]: Box, visit: (cell: number) => void): void {
    const at = (value: number, axis: 0 | 1): number =>
      Math.floor((value - this.corner[axis]) / this.side);
    for (let row = at(bottom, 1); row <= at(top, 1); ++row) {
      for (let column = at(left, 0); column <= at(right, 0); ++column) {
        visit(row * this.columns + column);
      }
    }
  }
}

function meet(a: Box, b: Box): boolean {
  return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}

/** The plane through three points over the picture. */
function depthOver([a, b, c]: readonly Point[], [za, zb, zc]: readonly number[]): HalfPlane {
  const [ux, uy, uz] = [b![0] - a![0], b![1] - a![1], zb! - za!];
  const [vx, vy, vz] = [c![0] - a![0], c![1] - a![1], zc! - za!];
  const area = ux * vy - uy * vx;
  const [p, q] = [(uz * vy - uy * vz) / area, (ux * vz - uz * vx) / area];
  return [p, q, za! - p * a![0] - q * a![1]];
}

/** Some faces of a model, seen from one side. */
export class Scene {
  private readonly points: Point[];
  private readonly depths: number[];
  private readonly shadows: Shadow[] = [];
  private readonly grid: Grid;
  private readonly close: number;
  private readonly least: number;
  private readonly dot: number;

  /** @param faces those that are there; of the model */
  constructor(
    private readonly model: Pick<Model, 'vertices' | 'faces'>,
    view: View,
    faces: readonly number[],
  ) {
    const corners = Array.from({ length: model.vertices.length / 3 }, (_, i) =>
      vectorAt(model.vertices, i),
    );
    this.points = corners.map((corner): Point => [dot(corner, view.right), dot(corner, view.up)]);
    this.depths = corners.map((corner) => dot(corner, view.towards));
    const [left, bottom, right, top] = boxOf(this.points);
    const extent = Math.max(right - left, top - bottom, Number.MIN_VALUE);
    this.close = closeness * extent;
    this.least = leastShare * extent * extent;
    this.dot = dotShare * extent;
    const closed = this.isClosed(faces);
    for (const face of faces) {
      const shadow = this.shadowOf(face);
      // Of a closed body the inner sides are never seen.
      if (shadow && !(closed && shadow.isBack)) this.shadows.push(shadow);
    }
    const columns = Math.max(1, Math.ceil(Math.sqrt(this.shadows.length)));
    this.grid = new Grid(this.shadows, extent / columns, columns + 1, [left, bottom]);
  }

  /** All that is seen of the faces, in their order. */
  areas(): VisibleArea[] {
    return this.shadows.flatMap((shadow, index) =>
      this.seen(shadow, index).map((walk) => ({ face: shadow.face, walk, isBack: shadow.isBack })),
    );
  }

  /** All that is seen of lines on the surface, in their order. */
  lines(lines: readonly ModelLine[]): VisibleLine[] {
    return lines.flatMap(([from, to], line) =>
      this.seenOf(from, to).map((segment) => ({ line, segment })),
    );
  }

  /** Whether a face shows its outer side; false for one that is seen from its edge. */
  showsFront(face: number): boolean {
    return areaOf(this.cornersOf(face)) > this.least;
  }

  private cornersOf(face: number): Point[] {
    return [0, 1, 2].map((corner) => this.points[this.model.faces[3 * face + corner]!]!);
  }

  private isClosed(faces: readonly number[]): boolean {
    const count = this.points.length;
    const open = new Set<number>();
    for (const face of faces) {
      for (let corner = 0; corner < 3; ++corner) {
        const from = this.model.faces[3 * face + corner]!;
        const to = this.model.faces[3 * face + ((corner + 1) % 3)]!;
        if (!open.delete(to * count + from)) open.add(from * count + to);
      }
    }
    return open.size === 0;
  }

  /** Null for a face that is seen from its edge. */
  private shadowOf(face: number): Shadow | null {
    const corners = this.cornersOf(face);
    const area = areaOf(corners);
    if (Math.abs(area) <= this.least) return null;
    const depths = [0, 1, 2].map((corner) => this.depths[this.model.faces[3 * face + corner]!]!);
    const isBack = area < 0;
    const walk = isBack ? [...corners].reverse() : corners;
    return {
      face,
      walk,
      isBack,
      sides: sidesOf(walk),
      box: boxOf(walk),
      depth: depthOver(corners, depths),
    };
  }

  /** What of a shadow no other one hides. */
  private seen(shadow: Shadow, index: number): Point[][] {
    let parts = [shadow.walk];
    for (const other of this.grid.near(shadow.box)) {
      if (other === index || parts.length === 0) continue;
      const front = this.shadows[other]!;
      if (!meet(shadow.box, front.box)) continue;
      const cover = this.coverOf(shadow, index, front, other);
      if (cover) parts = parts.flatMap((part) => this.without(part, front.box, cover));
    }
    return parts;
  }

  private without(part: Point[], box: Box, cover: readonly HalfPlane[]): Point[][] {
    if (!meet(boxOf(part), box)) return [part];
    const shared = clipped(part, cover);
    return shared.length === 0 || areaOf(shared) <= this.least
      ? [part]
      : remainder(part, cover, this.least);
  }

  /** Where a shadow is hidden by another one, as half-planes; null if nowhere. */
  private coverOf(
    back: Shadow,
    index: number,
    front: Shadow,
    other: number,
  ): readonly HalfPlane[] | null {
    const shared = clipped(back.walk, front.sides);
    if (shared.length === 0 || areaOf(shared) <= this.least) return null;
    const [p, q, r] = [0, 1, 2].map((i) => front.depth[i]! - back.depth[i]!);
    const ahead: HalfPlane = [p!, q!, r! - this.close];
    const gaps = shared.map((point) => depthIn(ahead, point));
    const [least, most] = [Math.min(...gaps), Math.max(...gaps)];
    if (most <= 0) {
      // Faces in one plane hide each other once.
      const inPlane = least >= -2 * this.close;
      return inPlane && other < index ? front.sides : null;
    }
    return least >= 0 ? front.sides : [...front.sides, ahead];
  }

  /** The parts of a line on the surface that no face hides. */
  private seenOf(from: number, to: number): Segment[] {
    const [a, b] = [this.points[from]!, this.points[to]!];
    const at = (share: number): Point => [
      a[0] + share * (b[0] - a[0]),
      a[1] + share * (b[1] - a[1]),
    ];
    const depthAt = (share: number): number =>
      this.depths[from]! + share * (this.depths[to]! - this.depths[from]!);
    let spans: [number, number][] = [[0, 1]];
    for (const index of this.grid.near(boxOf([a, b]))) {
      const hidden = this.hiddenSpan(this.shadows[index]!, at, depthAt);
      if (hidden) spans = spans.flatMap((span) => outside(span, hidden));
    }
    const length = Math.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2);
    return spans
      .filter(([start, end]) => end - start === 1 || (end - start) * length > this.dot)
      .map(([start, end]) => [at(start), at(end)]);
  }

  /** The shares of a line between which a face hides it. */
  private hiddenSpan(
    { sides, depth }: Shadow,
    at: (share: number) => Point,
    depthAt: (share: number) => number,
  ): [number, number] | null {
    const [start, end] = [at(0), at(1)];
    let [from, to] = [0, 1];
    const keep = (here: number, there: number): void => {
      if (here <= 0 && there <= 0) to = -1;
      else if (here < 0) from = Math.max(from, here / (here - there));
      else if (there < 0) to = Math.min(to, here / (here - there));
    };
    for (const side of sides) keep(depthIn(side, start), depthIn(side, end));
    // What lies on the surface is not hidden by it.
    const slack = 100 * this.close;
    keep(depthIn(depth, start) - depthAt(0) - slack, depthIn(depth, end) - depthAt(1) - slack);
    return from < to ? [from, to] : null;
  }
}

function outside([from, to]: [number, number], hidden: [number, number]): [number, number][] {
  const spans: [number, number][] = [
    [from, Math.min(to, hidden[0])],
    [Math.max(from, hidden[1]), to],
  ];
  return spans.filter(([start, end]) => end > start);
}
