import { Color, Group } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { nextCorner } from './edge-lines.js';
import type { MarkKind } from './sheet-marks.js';

/** The colours that the same edges have on the sheets: the side that is meant, and the other one. */
const own = new Color('#ad381e').toArray();
const partner = new Color('#0072b2').toArray();

/** What a building step is about, as on the sheets. */
const kindColours: Readonly<Record<MarkKind, readonly number[]>> = {
  turn: own,
  seam: new Color('#6c747d').toArray(),
  border: partner,
};

/** Pixels: wider than the lines between parts, on a white line that keeps them apart from any colour of a part. */
const [width, groundWidth] = [5, 9];

/**
 * Steps of the depth buffer by which lines come nearer. In valleys half of a line's width would else be behind the
 * faces beside it; what is behind the model stays there.
 */
const nearer = -2000;

function materialOf(linewidth: number, vertexColors: boolean): LineMaterial {
  const polygonOffsetUnits = vertexColors ? 1.5 * nearer : nearer;
  return new LineMaterial({ linewidth, vertexColors, polygonOffset: true, polygonOffsetUnits });
}

/** Edges of a model that are lit: lines in front of its faces, wherever these are. */
export class ModelLights {
  readonly group = new Group();
  private readonly lines = [materialOf(groundWidth, false), materialOf(width, true)].map(
    (material) => new LineSegments2(new LineSegmentsGeometry(), material),
  );
  private faces: Int32Array = new Int32Array();
  /** The corner at which a face begins to walk an edge, by the vertices of the edge; made for the first light. */
  private corners: Map<string, number> | null = null;
  private edges: Int32Array = new Int32Array();
  private kinds: readonly MarkKind[] = [];
  private isStale = false;
  private wasWhole = true;

  constructor() {
    for (const line of this.lines) line.frustumCulled = false;
    this.group.add(...this.lines);
    this.group.visible = false;
  }

  /** Takes another model, of which nothing is lit yet. */
  take(faces: Int32Array): void {
    this.faces = faces;
    this.corners = null;
    this.show(new Int32Array());
  }

  /**
   * Lights edges in place of those before; 2 vertices each, in the order of the side that is meant. With `kinds`, one
   * for each edge, both sides have the colour of their kind.
   */
  show(edges: Int32Array, kinds: readonly MarkKind[] = []): void {
    this.edges = edges;
    this.kinds = kinds;
    this.isStale = true;
  }

  /**
   * Puts the lines where the faces are.
   *
   * @param positions 3 numbers per corner of the faces
   * @param isWhole whether both sides of every edge are at the same place
   */
  place(positions: Float32Array, isWhole: boolean): void {
    if (!this.isStale && isWhole && this.wasWhole) return;
    [this.isStale, this.wasWhole] = [false, isWhole];
    this.group.visible = this.edges.length > 0;
    if (!this.group.visible) return;
    const [points, colours]: [number[], number[]] = [[], []];
    const add = (corner: number | undefined, colour: readonly number[]): void => {
      if (corner === undefined) return;
      for (const end of [corner, nextCorner(corner)]) {
        points.push(...positions.subarray(3 * end, 3 * end + 3));
        colours.push(...colour);
      }
    };
    for (let at = 0; at < this.edges.length; at += 2) {
      const [v, w] = [this.edges[at]!, this.edges[at + 1]!];
      const [here, there] = [this.cornerOf(v, w), this.cornerOf(w, v)];
      const kind = this.kinds[at / 2];
      add(here ?? there, kind ? kindColours[kind] : own);
      if (here !== undefined && !isWhole) add(there, kind ? kindColours[kind] : partner);
    }
    const geometry = new LineSegmentsGeometry().setPositions(points).setColors(colours);
    this.lines[0]!.geometry.dispose();
    for (const line of this.lines) line.geometry = geometry;
  }

  dispose(): void {
    for (const { geometry, material } of this.lines) {
      geometry.dispose();
      material.dispose();
    }
  }

  private cornerOf(from: number, to: number): number | undefined {
    this.corners ??= new Map(
      [...this.faces].map((vertex, corner) => [
        `${vertex} ${this.faces[nextCorner(corner)]!}`,
        corner,
      ]),
    );
    return this.corners.get(`${from} ${to}`);
  }
}
