/** Makes the nets of a file a job's: which faces belong together, what is cut, and which flaps there are. */
import { flapHeights } from './default-options.js';
import { FileFaces, type Triangles } from './file-faces.js';
import type { FileNets } from './file-nets.js';
import { Groups } from './groups.js';
import type { EdgeLock, FlapChoice, Up } from './job-options.js';
import { cross, direction, dot, length, minus, vectorAt, type Vector } from './vector.js';

/**
 * Faces that are flatter to each other than this, in radians, are taken for one: 0.01 degrees. The engine never cuts
 * below a tenth of that, and the floats that the model is told in are not more precise for small faces.
 */
const flat = (0.01 * Math.PI) / 180;

/** An edge of the model, as the file has it. */
interface Edge {
  /** In the direction of the first triangle. */
  vertices: readonly [number, number];
  /** The second one is -1 at a border. */
  triangles: readonly [number, number];
  /** Of the file, on both sides; -1 inside a face or where there is none. */
  corners: readonly [number, number];
  isFlat: boolean;
  isJoined: boolean;
}

export interface KeptNets {
  /** Per face of the model: its net. */
  labels: Int32Array;
  count: number;
  /** The edges at which nets end, or are slit. */
  locks: EdgeLock[];
  /** Empty where the file has no flaps. */
  flapEdges: FlapChoice[];
  /** Cuts of the file that lie in flat faces, which stay whole. */
  uncut: number;
}

class NetKeeper {
  private readonly edges: Edge[] = [];

  constructor(
    private readonly nets: FileNets,
    private readonly model: Triangles,
    private readonly faces: FileFaces,
    private readonly ofTriangles: Int32Array,
  ) {
    const first = new Map<string, number>();
    for (let at = 0; at < model.faces.length; ++at) {
      const [from, to] = this.endsOf(at);
      const other = first.get(`${to} ${from}`);
      if (other === undefined) first.set(`${from} ${to}`, at);
      else this.addEdge(other, at);
      if (other !== undefined) first.delete(`${to} ${from}`);
    }
    for (const at of first.values()) this.addEdge(at, -1);
  }

  keep(): KeptNets {
    this.joinAlongLines();
    const groups = new Groups(this.ofTriangles.length);
    for (const { isFlat, isJoined, triangles } of this.edges) {
      if (isFlat || isJoined) groups.unite(...triangles);
    }
    const numbers = new Map<number, number>();
    const labels = Int32Array.from(this.ofTriangles, (_, triangle) => {
      const group = groups.of(triangle);
      if (!numbers.has(group)) numbers.set(group, numbers.size);
      return numbers.get(group)!;
    });
    const isCut = ({ isFlat, isJoined }: Edge): boolean => !isFlat && !isJoined;
    const cuts = this.edges.filter(isCut);
    return {
      labels,
      count: numbers.size,
      locks: cuts
        .filter(({ triangles }) => triangles[1] !== -1)
        .map(({ vertices: [from, to] }) => ({ from, to, as: 'cut' })),
      flapEdges: this.flapsOf(cuts),
      uncut: this.edges.filter(({ isFlat, isJoined }) => isFlat && !isJoined).length,
    };
  }

  private endsOf(at: number): [number, number] {
    const { faces } = this.model;
    const first = at - (at % 3);
    return [faces[at]!, faces[first + ((at + 1) % 3)]!];
  }

  /** @param other the same edge in its second triangle, -1 for none */
  private addEdge(at: number, other: number): void {
    const vertices = this.endsOf(at);
    const triangleOf = (place: number): number => (place === -1 ? -1 : Math.floor(place / 3));
    const triangles = [triangleOf(at), triangleOf(other)] as const;
    const [one, two] = triangles.map((triangle) => this.ofTriangles[triangle] ?? -1);
    const cornerAt = (face: number): number =>
      face === -1 ? -1 : this.faces.cornerAt(face, vertices);
    const corners = [cornerAt(one!), cornerAt(two!)] as const;
    const isJoined =
      two !== -1 && (one === two || corners.some((corner) => this.nets.joined[corner] === 1));
    const isFlat = two !== -1 && this.isFlat(...triangles);
    this.edges.push({ vertices, triangles, corners, isFlat, isJoined });
  }

  private isFlat(one: number, other: number): boolean {
    const [a, b] = [this.normalOf(one), this.normalOf(other)];
    return length(cross(a, b)) < flat && dot(a, b) > 0;
  }

  private cornersOf(triangle: number): Vector[] {
    const { faces, vertices } = this.model;
    return [0, 1, 2].map((i) => vectorAt(vertices, faces[3 * triangle + i]!));
  }

  private normalOf(triangle: number): Vector {
    const [a, b, c] = this.cornersOf(triangle) as [Vector, Vector, Vector];
    return direction(cross(minus(b, a), minus(c, a)));
  }

  /**
   * Two flat faces that meet along a line of several edges fold along all of it or none: where the file joins one of
   * these edges, its sheet is whole there.
   */
  private joinAlongLines(): void {
    const panels = new Groups(this.ofTriangles.length);
    for (const { isFlat, triangles } of this.edges) if (isFlat) panels.unite(...triangles);
    const joined = new Map<string, Edge[]>();
    const keyOf = ({ triangles }: Edge): string =>
      triangles
        .map((triangle) => panels.of(triangle))
        .sort((a, b) => a - b)
        .join(' ');
    const inner = this.edges.filter(({ isFlat, triangles }) => !isFlat && triangles[1] !== -1);
    for (const edge of inner.filter(({ isJoined }) => isJoined)) {
      joined.set(keyOf(edge), [...(joined.get(keyOf(edge)) ?? []), edge]);
    }
    for (const edge of inner) {
      edge.isJoined ||=
        joined.get(keyOf(edge))?.some((other) => this.isOnLine(edge, other)) ?? false;
    }
  }

  private isOnLine({ vertices }: Edge, other: Edge): boolean {
    const point = (vertex: number): Vector => vectorAt(this.model.vertices, vertex);
    const [from, to] = [point(other.vertices[0]), point(other.vertices[1])];
    const along = direction(minus(to, from));
    return vertices.every((vertex) => {
      const way = minus(point(vertex), from);
      return length(cross(way, along)) <= 1e-4 * (length(way) + length(minus(to, from)));
    });
  }

  private flapsOf(cuts: readonly Edge[]): FlapChoice[] {
    const heightAt = (corner: number): number => this.nets.flaps[corner] ?? 0;
    const choices = cuts.map(({ vertices: [from, to], corners, triangles }): FlapChoice | null => {
      const [left, right] = [heightAt(corners[0]), heightAt(corners[1])];
      const isBorder = triangles[1] === -1;
      if (left === 0 && right === 0) return isBorder ? null : { from, to, flaps: 'none' };
      const one = left > 0 ? 'left' : 'right';
      const height = Math.min(flapHeights.most, Math.max(flapHeights.least, left, right));
      return { from, to, flaps: left > 0 && right > 0 ? 'both' : one, height };
    });
    const found = choices.filter((choice) => choice !== null);
    return found.some(({ flaps }) => flaps !== 'none') ? found : [];
  }
}

/**
 * The nets of a file for the model that was made of it; null where its faces are not to be found there any more, as
 * repairs or simplifying have changed them.
 *
 * @param up axis of the file that points up
 */
export function keptNets(nets: FileNets, model: Triangles, up: Up): KeptNets | null {
  const faces = new FileFaces(nets, model, up);
  const ofTriangles = faces.ofTriangles();
  return ofTriangles && new NetKeeper(nets, model, faces, ofTriangles).keep();
}
