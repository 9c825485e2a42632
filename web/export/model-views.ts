/** A model's faces and edges by the pieces that they belong to, and what views show of them. */
import type { JobResult } from '../model/job.js';
import { cross, dot, minus, times, vectorAt, type Vector } from '../model/vector.js';
import { areaOf } from './polygon.js';
import { Scene, type ModelLine, type VisibleArea } from './hidden-surfaces.js';
import type { Point } from './point.js';
import { viewFrom, viewNames, type View, type ViewName } from './view-direction.js';

/** An edge of the model with its one or two faces. */
export interface ModelEdge {
  ends: ModelLine;
  faces: number[];
}

/** What is seen of the whole model from one side. */
export interface ModelView {
  name: ViewName;
  view: View;
  scene: Scene;
  areas: VisibleArea[];
  /** Per piece: the area that is seen of its outer side; square millimetres. */
  shares: number[];
  /** The sum of all areas. */
  total: number;
}

/** Things are seldom seen from below: such pictures take time to understand. */
const ease: Readonly<Record<ViewName, number>> = {
  'front-left': 1,
  'front-right': 1,
  'back-right': 1,
  'back-left': 1,
  above: 0.8,
  below: 0.5,
};
/** And so do pictures from another side than the one before. */
const habit = 1.5;

/** Over the surface of a piece: a whole box shows a quarter and more, a lid that lies on another box some less. */
const leastVisible = 0.06;

/** Looks at a result from all sides, each once; all pictures of it are made of that. */
export class ModelViews {
  /** Per face of the model: index of its piece; -1 for one without. */
  readonly pieceOf: Int32Array;
  readonly edges: readonly ModelEdge[];
  /** Per face: its direction outwards, of unit length. */
  readonly normals: readonly Vector[];
  /** Per piece: its area. */
  private readonly surfaces: readonly number[];
  private readonly faces: number[];
  private readonly known = new Map<ViewName, ModelView>();

  constructor(readonly result: JobResult) {
    const { model, pieces } = result;
    this.pieceOf = new Int32Array(model.faces.length / 3).fill(-1);
    pieces.forEach(({ sources }, piece) => {
      for (const face of sources) this.pieceOf[face] = piece;
    });
    this.faces = [...this.pieceOf.keys()].filter((face) => this.pieceOf[face]! >= 0);
    this.edges = edgesOf(model.faces, model.vertices.length / 3, this.faces);
    this.surfaces = pieces.map(surfaceOf);
    this.normals = Array.from(this.pieceOf, (_, face) => this.normalOf(face));
  }

  from(name: ViewName): ModelView {
    const known = this.known.get(name);
    if (known) return known;
    const view = viewFrom(name);
    const scene = new Scene(this.result.model, view, this.faces);
    const areas = scene.areas();
    const shares = this.result.pieces.map(() => 0);
    let total = 0;
    for (const { face, walk, isBack } of areas) {
      const area = areaOf(walk);
      total += area;
      if (!isBack) shares[this.pieceOf[face]!]! += area;
    }
    const made = { name, view, scene, areas, shares, total };
    this.known.set(name, made);
    return made;
  }

  /** The view that shows most of a piece; `usual` as long as no other one shows much more. */
  bestFor(piece: number, usual: ViewName): ModelView {
    const worth = (name: ViewName): number =>
      this.from(name).shares[piece]! * ease[name] * (name === usual ? habit : 1);
    const best = viewNames.reduce((a, b) => (worth(b) > worth(a) ? b : a));
    return this.from(best);
  }

  /** Whether a view shows too little of a piece to know where it is. */
  hides({ shares }: ModelView, piece: number): boolean {
    return shares[piece]! < leastVisible * this.surfaces[piece]!;
  }

  /** Some pieces alone, from one side. */
  partly(view: View, isThere: (piece: number) => boolean): { scene: Scene; faces: number[] } {
    const faces = this.faces.filter((face) => isThere(this.pieceOf[face]!));
    return { scene: new Scene(this.result.model, view, faces), faces };
  }

  private normalOf(face: number): Vector {
    const { vertices, faces } = this.result.model;
    const [a, b, c] = [0, 1, 2].map((corner) => vectorAt(vertices, faces[3 * face + corner]!));
    const normal = cross(minus(b!, a!), minus(c!, a!));
    const size = Math.sqrt(dot(normal, normal));
    return size > 0 ? times(normal, 1 / size) : [0, 0, 1];
  }
}

/** Area of a piece; square millimetres. */
function surfaceOf({ faces, vertices }: JobResult['pieces'][number]): number {
  let sum = 0;
  for (let at = 0; at < faces.length; at += 3) {
    const corners = [0, 1, 2].map((corner): Point => {
      const vertex = faces[at + corner]!;
      return [vertices[2 * vertex]!, vertices[2 * vertex + 1]!];
    });
    sum += areaOf(corners);
  }
  return sum;
}

/** In the order in which the faces have them. */
function edgesOf(corners: Int32Array, vertices: number, faces: readonly number[]): ModelEdge[] {
  const known = new Map<number, ModelEdge>();
  for (const face of faces) {
    for (let corner = 0; corner < 3; ++corner) {
      const from = corners[3 * face + corner]!;
      const to = corners[3 * face + ((corner + 1) % 3)]!;
      const key = Math.min(from, to) * vertices + Math.max(from, to);
      const edge = known.get(key);
      if (edge) edge.faces.push(face);
      else known.set(key, { ends: [from, to], faces: [face] });
    }
  }
  return [...known.values()];
}
