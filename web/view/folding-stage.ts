import { bodiesOf, type Body } from '../model/body.js';
import { ballOf, type Ball, type Box3 } from '../model/bounds.js';
import { choreograph, flightTimes, foldEnd, poseOn, type Track } from '../model/choreography.js';
import { foldTree, type FoldTree } from '../model/fold-tree.js';
import { foldedVertices } from '../model/folded-piece.js';
import type { Model, Piece } from '../model/job.js';
import { posed, turnAfter, turnAround, type Pose } from '../model/pose.js';
import { dot, minus, plus, times, vectorAt, type Vector } from '../model/vector.js';
import { around, boxSeen, CameraPath, middleSeen, viewAxes, type ViewAxes } from './camera-path.js';
import { extentOf, writeNormals, type Extent } from './model-geometry.js';
import type { Folding } from './model-message.js';
import { viewHeight } from './orbit.js';

/** How steeply the table stands, in radians: as a drawing board, turned a little to the beholder. */
const tableSlope = 0.8;

/** Looks at the pieces while they fold, and at the flight of each, with which the camera's way is planned. */
const [foldingLooks, flightLooks] = [24, 8];

/** So many looks at all flights at most: flights of many pieces are short. */
const mostLooks = 200;

/** The share of its flight from which a piece counts for the camera: before that it comes from far away. */
const arrival = 0.85;

/** Someone who looks: angles in radians around the upright axis and above the horizon, and width over height of the view. */
export interface Beholder {
  around: number;
  height: number;
  aspect: number;
}

/** The share of the last flight at whose end the model is shown just as it is shown when it is whole. */
const lastStretch = 0.1;

/** Of a table: no view is so narrow or wide that its pieces would lie in one column or row. */
const [narrowest, widest] = [0.7, 2.2];

/** What is in view: a ball in the space of the model, and what of it is to be filled. */
interface Frame extends Ball {
  extent: Extent;
}

/**
 * The faces of a model wherever they are between the table and the model, as the graphics card takes
 * them: moved and scaled so that what moves, and in the end the model, fits the unit sphere.
 */
export class FoldingStage {
  /** Per corner of the model's faces, its vertex in the nets; no two pieces share one. */
  readonly netVertices: Int32Array;
  private readonly trees: FoldTree[];
  private readonly bodies: Body[];
  private readonly ball: Ball;
  /** 3 numbers per corner of the model's faces, in the space of the model. */
  private readonly corners: Float64Array;
  private shapes: Float64Array[] = [];
  /** Of what `shapes` are, from 0 to 1. */
  private shapeTime = NaN;
  private tracks: Track[] = [];
  private axes: ViewAxes = viewAxes(0, 0);
  private path: CameraPath | null = null;
  private readonly model: Frame;

  /** Takes some tenths of a second for a thousand faces. Call `turnTable` before anything else. */
  constructor(private readonly folding: Folding) {
    const { model, pieces } = folding;
    this.trees = pieces.map(foldTree);
    this.bodies = bodiesOf(folding, this.trees);
    this.ball = ballOf(model.vertices);
    this.corners = new Float64Array(3 * model.faces.length);
    this.model = {
      ...this.ball,
      extent: extentOf(fitted(cornersOf(model), this.ball), viewHeight),
    };
    this.netVertices = new Int32Array(model.faces.length);
    let first = 0;
    for (const { faces, sources, vertices } of pieces) {
      faces.forEach((vertex, at) => (this.netVertices[cornerOf(sources, at)] = first + vertex));
      first += vertices.length / 2;
    }
  }

  /** Turns the table to someone who looks from there. */
  turnTable(beholder: Beholder): void {
    const { around, aspect } = beholder;
    const slope = turnAround([1, 0, 0], -tableSlope);
    const table = turnAfter(turnAround([0, 1, 0], around), slope);
    const shape = Math.min(Math.max(aspect, narrowest), widest);
    this.tracks = choreograph(this.bodies, this.ball, table, shape);
    this.lookFrom(beholder);
  }

  /** Plans the camera's way anew for someone who has turned the pieces. */
  lookFrom(beholder: Omit<Beholder, 'aspect'>): void {
    this.axes = viewAxes(beholder.around, beholder.height);
    const count = this.bodies.length;
    const { start, end } = flightTimes(0, count);
    const looks = Math.min(Math.ceil((flightLooks * (1 - foldEnd)) / (end - start)), mostLooks);
    const times = [
      ...Array.from({ length: foldingLooks }, (_, i) => (foldEnd * i) / foldingLooks),
      ...Array.from({ length: looks + 1 }, (_, i) => foldEnd + ((1 - foldEnd) * i) / looks),
    ];
    this.path = new CameraPath(
      times,
      times.map((time) => this.boxAt(time)),
    );
  }

  /**
   * Writes positions and normals of all corners at a time from 0 (flat) to 1 (the model); what of
   * the unit sphere is to be seen.
   */
  write(time: number, positions: Float32Array, normals: Float32Array): Extent {
    const { centre, radius, extent } = this.frameAt(time);
    positions.set(fitted(this.cornersAt(time), { centre, radius }));
    writeNormals(normals, positions);
    return extent;
  }

  /** What is in view at a time: what moves, and in the end the model just as it is shown when it is whole. */
  private frameAt(time: number): Frame {
    const seen = frameOf(this.path!.at(time), this.axes);
    const begin = 1 - lastStretch * (1 - this.lastStart);
    const share = Math.min(Math.max((time - begin) / (1 - begin), 0), 1);
    // Neither begins nor ends with a jerk.
    return mixed(seen, this.model, share * share * (3 - 2 * share));
  }

  /** When the last piece rises. */
  private get lastStart(): number {
    const { length } = this.bodies;
    return flightTimes(length - 1, length).start;
  }

  /** Around what is to be seen at a time; when the last piece arrives there has to be room for the model however it is turned. */
  private boxAt(time: number): Box3 {
    const shapes = this.shapesAt(time);
    const boxes = shapes.flatMap((shape, i) => {
      return this.isSeen(i, time) ? [boxSeen(shape, this.axes, poseOn(this.tracks[i]!, time))] : [];
    });
    const isLast = time > this.lastStart + arrival * (1 - this.lastStart);
    return around(...boxes, ...(isLast ? [boxOfFrame(this.model, this.axes)] : []));
  }

  /** Whether the camera looks at a piece: at all that fold; then at those in the model and on their last way to it. */
  private isSeen(piece: number, time: number): boolean {
    const { length } = this.bodies;
    const { rank } = this.bodies[piece]!;
    const { start, end } = flightTimes(rank, length);
    // Somebody has to be the first.
    return time <= foldEnd || time > (rank === 0 ? start : start + arrival * (end - start));
  }

  /** The pieces on their sheets, 3 numbers per vertex, as far folded as they are at a time. */
  private shapesAt(time: number): readonly Float64Array[] {
    const shapeTime = Math.min(1, time / foldEnd);
    if (shapeTime !== this.shapeTime) {
      const { pieces } = this.folding;
      this.shapes = pieces.map((piece, i) => foldedVertices(piece, this.trees[i]!, shapeTime));
      this.shapeTime = shapeTime;
    }
    return this.shapes;
  }

  private cornersAt(time: number): Float64Array {
    const shapes = this.shapesAt(time);
    this.folding.pieces.forEach((piece, i) => {
      this.place(piece, shapes[i]!, poseOn(this.tracks[i]!, time));
    });
    return this.corners;
  }

  private place({ faces, sources }: Piece, shape: Float64Array, pose: Pose): void {
    const placed = new Float64Array(shape.length);
    for (let i = 0; i < shape.length / 3; ++i) placed.set(posed(pose, vectorAt(shape, i)), 3 * i);
    faces.forEach((vertex, at) => {
      this.corners.set(placed.subarray(3 * vertex, 3 * vertex + 3), 3 * cornerOf(sources, at));
    });
  }
}

/** The corner of the model for a corner of a piece's faces. */
function cornerOf(sources: Int32Array, at: number): number {
  return 3 * sources[Math.floor(at / 3)]! + (at % 3);
}

/** Positions in which a ball is the unit sphere. */
function fitted(corners: Float64Array, { centre, radius }: Ball): Float32Array {
  return Float32Array.from(corners, (value, i) => (value - centre[i % 3]!) / (radius || 1));
}

/** 3 numbers per corner of the faces of a model. */
function cornersOf({ vertices, faces }: Model): Float64Array {
  return Float64Array.from({ length: 3 * faces.length }, (_, i) => {
    return vertices[3 * faces[Math.floor(i / 3)]! + (i % 3)]!;
  });
}

/** A box in view as what fills it. */
function frameOf(box: Box3, axes: ViewAxes): Frame {
  const [reach, up, near] = times(minus(box.high, box.low), 0.5);
  const radius = Math.hypot(reach, up, near) || 1;
  const extent = { up: up / radius, reach: reach / radius, near: near / radius, deep: false };
  return { centre: middleSeen(box, axes), radius, extent };
}

/** The same the other way round. */
function boxOfFrame({ centre, radius, extent: { reach, up, near } }: Frame, axes: ViewAxes): Box3 {
  const half = times([reach, up, near], radius);
  const middle: Vector = [dot(axes[0], centre), dot(axes[1], centre), dot(axes[2], centre)];
  return { low: minus(middle, half), high: plus(middle, half) };
}

/** Between two frames, at a share of the way from one to the other. */
function mixed(a: Frame, b: Frame, share: number): Frame {
  const mix = (from: number, to: number): number => (1 - share) * from + share * to;
  return {
    centre: plus(times(a.centre, 1 - share), times(b.centre, share)),
    // Evenly to the eye: by the same factor in the same time.
    radius: a.radius * (b.radius / a.radius) ** share,
    extent: {
      up: mix(a.extent.up, b.extent.up),
      reach: mix(a.extent.reach, b.extent.reach),
      near: mix(a.extent.near, b.extent.near),
      deep: b.extent.deep,
    },
  };
}
