import { bodiesOf, type Body } from '../model/body.js';
import { ballOf, type Ball } from '../model/bounds.js';
import { choreograph, foldEnd, poseOn, type Track } from '../model/choreography.js';
import { foldTree, type FoldTree } from '../model/fold-tree.js';
import { foldedVertices } from '../model/folded-piece.js';
import type { Piece } from '../model/job.js';
import { posed, turnAfter, turnAround, type Pose } from '../model/pose.js';
import { plus, times, vectorAt } from '../model/vector.js';
import { extentOf, extentSeen, writeNormals, type Extent } from './model-geometry.js';
import type { Folding } from './model-message.js';
import { viewHeight } from './orbit.js';

/** How steeply the table stands, in radians: as a drawing board, turned a little to the beholder. */
const tableSlope = 0.8;

/** Zooming begins slowly, as long as most of the pieces still lie on the table. */
const zoomPower = 2;

/** Halfway, room for the pieces that fly around the model, as a share of what is in view. */
const airForFlights = 0.3;

/** What is in view: a ball in the space of the model, and what of it is to be filled. */
interface Frame extends Ball {
  extent: Extent;
}

/**
 * The faces of a model wherever they are between the table and the model, as the graphics card takes
 * them: moved and scaled so that at first the table and in the end the model fits the unit sphere.
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
  private frames: { table: Frame; model: Frame } | null = null;

  /** Takes some tenths of a second for a thousand faces. Call `turnTable` before anything else. */
  constructor(private readonly folding: Folding) {
    const { model, pieces } = folding;
    this.trees = pieces.map(foldTree);
    this.bodies = bodiesOf(folding, this.trees);
    this.ball = ballOf(model.vertices);
    this.corners = new Float64Array(3 * model.faces.length);
    this.netVertices = new Int32Array(model.faces.length);
    let first = 0;
    for (const { faces, sources, vertices } of pieces) {
      faces.forEach((vertex, at) => (this.netVertices[cornerOf(sources, at)] = first + vertex));
      first += vertices.length / 2;
    }
  }

  /** Turns the table to someone who looks from this angle around the upright axis. */
  turnTable(around: number): void {
    const slope = turnAround([1, 0, 0], -tableSlope);
    const table = turnAfter(turnAround([0, 1, 0], around), slope);
    this.tracks = choreograph(this.bodies, this.ball, table);
    const frame = (time: number, extent: (positions: Float32Array) => Extent): Frame => {
      const corners = this.cornersAt(time);
      const ball = ballOf(corners);
      return { ...ball, extent: extent(fitted(corners, ball)) };
    };
    this.frames = {
      // The table is seen from the front; the model may be turned.
      table: frame(0, (positions) => extentSeen(positions, viewHeight, around)),
      model: frame(1, (positions) => extentOf(positions, viewHeight)),
    };
  }

  /**
   * Writes positions and normals of all corners at a time from 0 (flat) to 1 (the model); what of
   * the unit sphere is to be seen.
   */
  write(time: number, positions: Float32Array, normals: Float32Array): Extent {
    const { table, model } = this.frames!;
    const share = Math.max(0, (time - foldEnd) / (1 - foldEnd));
    const zoom = share ** zoomPower;
    const mix = (a: number, b: number): number => (1 - zoom) * a + zoom * b;
    const centre = plus(times(table.centre, 1 - share), times(model.centre, share));
    const air = 1 + airForFlights * 4 * share * (1 - share);
    // Evenly to the eye: by the same factor in the same time.
    const radius = table.radius * (model.radius / table.radius) ** zoom * air;
    positions.set(fitted(this.cornersAt(time), { centre, radius }));
    writeNormals(normals, positions);
    return {
      ...model.extent,
      up: mix(table.extent.up, model.extent.up),
      reach: mix(table.extent.reach, model.extent.reach),
    };
  }

  private cornersAt(time: number): Float64Array {
    const shapeTime = Math.min(1, time / foldEnd);
    const { pieces } = this.folding;
    if (shapeTime !== this.shapeTime) {
      this.shapes = pieces.map((piece, i) => foldedVertices(piece, this.trees[i]!, shapeTime));
      this.shapeTime = shapeTime;
    }
    pieces.forEach((piece, i) => this.place(piece, this.shapes[i]!, poseOn(this.tracks[i]!, time)));
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
