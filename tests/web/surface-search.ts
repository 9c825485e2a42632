/** Finds the places of a surface that lie where a face of a model does. */
import { colourAt, type Rgb, type TrueSurface } from './true-surface.js';

export type Vector = [number, number, number];

const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

function boxOf(values: ArrayLike<number>): { least: Vector; most: Vector } {
  const least: Vector = [Infinity, Infinity, Infinity];
  const most: Vector = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < values.length; ++i) {
    least[i % 3] = Math.min(least[i % 3]!, values[i]!);
    most[i % 3] = Math.max(most[i % 3]!, values[i]!);
  }
  return { least, most };
}

/** The nearest point of a side: how far along it. */
function alongSide(point: Vector, from: Vector, to: Vector): number {
  const side = minus(to, from);
  return Math.min(1, Math.max(0, dot(minus(point, from), side) / (dot(side, side) || 1)));
}

interface Nearest {
  distance: number;
  b: number;
  c: number;
}

/** The nearest place of a triangle: within it, or else on one of its three sides. */
function nearestOn([p, q, r]: readonly [Vector, Vector, Vector], point: Vector): Nearest {
  const [u, v, w] = [minus(q, p), minus(r, p), minus(point, p)];
  const normal = cross(u, v);
  const area = dot(normal, normal);
  const tried: [b: number, c: number][] = [];
  const b = dot(cross(w, v), normal) / area;
  const c = dot(cross(u, w), normal) / area;
  if (b >= 0 && c >= 0 && b + c <= 1) tried.push([b, c]);
  else {
    const [onPq, onPr, onQr] = [
      alongSide(point, p, q),
      alongSide(point, p, r),
      alongSide(point, q, r),
    ];
    tried.push([onPq, 0], [0, onPr], [1 - onQr, onQr]);
  }
  const [nearest] = tried
    .map(([s, t]) => {
      const way = [0, 1, 2].map((i) => w[i]! - s * u[i]! - t * v[i]!);
      return { distance: Math.hypot(...way), b: s, c: t };
    })
    .sort((one, other) => one.distance - other.distance);
  return nearest!;
}

/** Colours of a place; the first one is that of the nearest face, others lie upon it. */
export interface FoundColours {
  colours: Rgb[];
  distance: number;
}

/** Shares of the model's size: what counts as the same place, and how far a face may be from its surface. */
const samePlace = 1e-4;
const reach = 2e-3;
/** Cosine of the angle to which faces look the same way. */
const sameWay = 0.7;

export class SurfaceSearch {
  readonly size: number;
  private readonly triangles: [Vector, Vector, Vector][] = [];
  private readonly normals: Vector[] = [];
  private readonly boxes: ReturnType<typeof boxOf>[] = [];
  private readonly isSimplified: boolean;

  /**
   * The surface is brought to the size and the place of the model; up is up in both.
   *
   * @param vertices of the model
   * @param deviation how far simplifying has moved them
   */
  constructor(
    private readonly surface: TrueSurface,
    vertices: Float64Array,
    private readonly deviation: number,
  ) {
    const [model, own] = [boxOf(vertices), boxOf(surface.corners)];
    this.size = Math.hypot(...minus(model.most, model.least));
    this.isSimplified = deviation > 0;
    const scale = this.size / Math.hypot(...minus(own.most, own.least));
    const moved = (value: number, i: number): number => {
      const middle = (own.least[i]! + own.most[i]!) / 2;
      return (model.least[i]! + model.most[i]!) / 2 + scale * (value - middle);
    };
    for (let at = 0; at < surface.corners.length; at += 9) {
      const corner = (i: number): Vector =>
        [0, 1, 2].map((axis) => moved(surface.corners[at + 3 * i + axis]!, axis)) as Vector;
      const triangle: [Vector, Vector, Vector] = [corner(0), corner(1), corner(2)];
      const normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
      const length = Math.hypot(...normal);
      this.triangles.push(triangle);
      this.boxes.push(boxOf(triangle.flat()));
      this.normals.push(normal.map((value) => value / (length || 1)) as Vector);
    }
  }

  /** What lies about a face of the model, and looks the same way; whatever lies there if nothing does. */
  near(corners: readonly Vector[]): { at(shares: Vector): FoundColours } {
    const beyond = reach * this.size + 3 * this.deviation;
    const { least, most } = boxOf(corners.flat());
    const about = this.boxes.flatMap((box, i) => {
      const isNear = [0, 1, 2].every(
        (axis) =>
          box.least[axis]! <= most[axis]! + beyond && box.most[axis]! >= least[axis]! - beyond,
      );
      return isNear && dot(this.normals[i]!, this.normals[i]!) > 0.5 ? [i] : [];
    });
    const normal = cross(minus(corners[1]!, corners[0]!), minus(corners[2]!, corners[0]!));
    const length = Math.hypot(...normal);
    // What is simplified may lie a little aslant.
    const aslant = this.isSimplified ? 0 : sameWay;
    const facing = about.filter((i) => dot(normal, this.normals[i]!) > aslant * length);
    const candidates = facing.length > 0 ? facing : about;
    return {
      at: (shares) => {
        const point = [0, 1, 2].map((axis) =>
          shares.reduce((sum, share, i) => sum + share * corners[i]![axis]!, 0),
        ) as Vector;
        return this.coloursAt(point, candidates);
      },
    };
  }

  private coloursAt(point: Vector, candidates: readonly number[]): FoundColours {
    const found = candidates
      .map((triangle) => ({ triangle, ...nearestOn(this.triangles[triangle]!, point) }))
      .sort((one, other) => one.distance - other.distance);
    const distance = found[0]?.distance ?? Infinity;
    const same = found.filter((one) => one.distance <= distance + samePlace * this.size);
    return {
      colours: same.map(({ triangle, b, c }) => colourAt(this.surface, triangle, b, c)),
      distance,
    };
  }
}
