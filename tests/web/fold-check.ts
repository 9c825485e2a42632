/**
 * Judges a FOLD file by what a person needs from it: can these nets be cut out and folded into this
 * model? Recomputes everything from coordinates and shares no code with what writes the files.
 */
import type { FoldFile, NetFrame } from './fold-file.js';
import { checkKeyFrame } from './key-frame-check.js';
import { checkMotion } from './motion-check.js';
import {
  edgeFaults,
  edgeKey,
  overlapFaults,
  shapeFaults,
  sidesOf,
  type Side,
} from './pattern-check.js';
import { cross, distance, dot, length, minus, type Vector } from './vectors.js';

/** Relative to the longest edge of a face. */
const lengthTolerance = 1e-6;
/** Relative to the distance; what is not straight within this, the lengths of the faces tell. */
const lineTolerance = 1e-5;
/** Degrees; single sharp faces get more, see `angleTolerance`. */
const leastAngleTolerance = 1e-4;
/** Folds below this many degrees are flat. */
const flatAngle = 1e-3;

/** Normal of a polygon by Newell's method; its length is twice the area. */
function normalOf(corners: Vector[]): Vector {
  const sum = [0, 0, 0];
  corners.forEach((p, i) => {
    const q = corners[(i + 1) % corners.length]!;
    cross(minus(p, corners[0]!), minus(q, corners[0]!)).forEach((value, axis) => {
      sum[axis]! += value;
    });
  });
  return sum;
}

function signedArea(corners: Vector[]): number {
  let sum = 0;
  corners.forEach((p, i) => {
    const q = corners[(i + 1) % corners.length]!;
    sum += p[0]! * q[1]! - p[1]! * q[0]!;
  });
  return sum / 2;
}

/** Whether the ends of the second segment lie on the line through the first. */
function onOneLine([a, b]: Vector[], other: Vector[]): boolean {
  const along = minus(b!, a!);
  return other.every((point) => {
    const to = minus(point, a!);
    const beside = Math.abs(along[0]! * to[1]! - along[1]! * to[0]!) / length(along);
    return beside <= lineTolerance * length(to);
  });
}

const longestEdge = (corners: Vector[]): number =>
  Math.max(...corners.map((p, i) => distance(p, corners[(i + 1) % corners.length]!)));

/** Rounding of the coordinates tilts the normals of needles and of small faces far away. */
function angleTolerance(corners: Vector[]): number {
  const height = length(normalOf(corners)) / longestEdge(corners);
  const extent = Math.max(...corners.flat().map(Math.abs));
  return leastAngleTolerance + (1e-13 * extent) / height;
}

/** Fold angle in degrees between two faces at an edge that `a` walks from `from` to `to`. */
function foldAngle(a: Vector[], b: Vector[], from: Vector, to: Vector): number {
  const [m, n, along] = [normalOf(a), normalOf(b), minus(to, from)];
  const sine = dot(cross(m, n), along) / length(along);
  // On a convex edge the normals turn around the direction in which the face walks it.
  return (-Math.atan2(sine, dot(m, n)) * 180) / Math.PI;
}

/** One net under examination, and what is wrong with it. */
class NetCheck {
  readonly violations: string[] = [];
  private readonly sides: Map<string, Side[]>;

  constructor(
    private readonly file: FoldFile,
    private readonly net: NetFrame,
  ) {
    this.sides = sidesOf(net);
  }

  run(): string[] {
    this.checkShape();
    if (this.violations.length === 0) {
      edgeFaults(this.net).forEach((sentence) => this.say(sentence));
      this.checkConnected();
      this.checkTree();
      this.checkCorners();
      overlapFaults(this.net).forEach((sentence) => this.say(sentence));
    }
    return this.violations;
  }

  private say(sentence: string): void {
    this.violations.push(`piece ${this.net['foldwright:piece']}: ${sentence}`);
  }

  private source(face: number): number[] {
    return this.file.model.faces_vertices[this.net['faces_foldwright:source'][face]!]!;
  }

  private flat(face: number): Vector[] {
    return this.net.faces_vertices[face]!.map((vertex) => this.net.vertices_coords[vertex]!);
  }

  private solid(face: number): Vector[] {
    return this.source(face).map((vertex) => this.file.model.vertices_coords[vertex]!);
  }

  /** The shape of the frame, and that its faces have originals. */
  private checkShape(): void {
    const { net, file } = this;
    shapeFaults(net).forEach((sentence) => this.say(sentence));
    net['faces_foldwright:source'].slice(0, net.faces_vertices.length).forEach((source, face) => {
      const original = file.model.faces_vertices[source];
      if (!original) this.say(`face ${face} has no original ${source}`);
      else if (original.length !== net.faces_vertices[face]!.length) {
        this.say(`face ${face} has another number of corners than its original ${source}`);
      }
    });
  }

  /** Pairs of faces joined by an edge with one of these assignments. */
  private joints(assignments: string): [number, number][] {
    return this.net.edges_vertices.flatMap(([a, b], edge): [number, number][] => {
      const sides = this.sides.get(edgeKey(a!, b!)) ?? [];
      if (sides.length !== 2 || !assignments.includes(this.net.edges_assignment[edge]!)) return [];
      return [[sides[0]!.face, sides[1]!.face]];
    });
  }

  /** For each face the lowest face that these joints connect it with. */
  private components(joints: [number, number][]): number[] {
    const root = this.net.faces_vertices.map((_, face) => face);
    const find = (face: number): number => {
      while (root[face] !== face) face = root[face] = root[root[face]!]!;
      return face;
    };
    for (const [a, b] of joints) {
      const [x, y] = [find(a), find(b)];
      root[Math.max(x, y)] = Math.min(x, y);
    }
    return root.map(find);
  }

  private checkConnected(): void {
    const parts = new Set(this.components(this.joints('MVF'))).size;
    if (parts !== 1) this.say(`falls into ${parts} pieces`);
  }

  /**
   * With flat panels taken as one, the folds form a tree. Edges between the same two panels on one
   * line are one fold.
   */
  private checkTree(): void {
    const panelOf = this.components(this.joints('F'));
    const lines = new Map<string, Vector[][]>();
    this.net.edges_vertices.forEach((ends, edge) => {
      const sides = this.sides.get(edgeKey(ends[0]!, ends[1]!)) ?? [];
      if (sides.length !== 2 || !'MV'.includes(this.net.edges_assignment[edge]!)) return;
      const key = edgeKey(panelOf[sides[0]!.face]!, panelOf[sides[1]!.face]!);
      const line = ends.map((vertex) => this.net.vertices_coords[vertex]!);
      const known = lines.get(key) ?? [];
      if (!known.some((other) => onOneLine(other, line))) lines.set(key, [...known, line]);
    });
    const folds = [...lines.values()].flat().length;
    const loops = folds - (new Set(panelOf).size - 1);
    if (loops > 0) this.say(`its folds close ${loops} loops: it cannot be flat and folded`);
  }

  /**
   * Follows the folds from the first face and requires each face to be its original, laid flat.
   * Which corner stands for which is fixed by the first face; where its own symmetry leaves a
   * choice, one of the choices has to work.
   */
  private checkCorners(): void {
    const first = this.net.faces_vertices[0]!.length;
    let best: string[] | null = null;
    for (let turn = 0; turn < first; ++turn) {
      const found = this.walk(turn);
      if (!best || found.length < best.length) best = found;
      if (best.length === 0) break;
    }
    best?.forEach((sentence) => this.say(sentence));
  }

  /** Corner i of each face stands for corner i + turn of its original; null where unreached. */
  private walk(firstTurn: number): string[] {
    const { net } = this;
    const found: string[] = [];
    const turns: (number | null)[] = net.faces_vertices.map(() => null);
    const assignmentOf = new Map(net.edges_vertices.map(([a, b], i) => [edgeKey(a!, b!), i]));
    turns[0] = firstTurn;
    const queue = [0];
    for (let face = queue.shift(); face !== undefined; face = queue.shift()) {
      const corners = net.faces_vertices[face]!;
      found.push(...this.congruence(face, turns[face]!));
      corners.forEach((from, corner) => {
        const key = edgeKey(from, corners[(corner + 1) % corners.length]!);
        const other = this.sides.get(key)!.find((side) => side.face !== face);
        const edge = assignmentOf.get(key);
        if (!other || edge === undefined) return;
        const turn = this.turnAcross(face, corner, turns[face]!, other);
        if (turn === null) {
          found.push(`edge ${edge} joins faces that share no such edge in the model`);
          return;
        }
        if (face < other.face) found.push(...this.foldOf(edge, face, corner, turns, other.face));
        if (turns[other.face] === null) {
          turns[other.face] = turn;
          queue.push(other.face);
        } else if (turns[other.face] !== turn) {
          found.push(`edge ${edge} joins face ${other.face} at another corner than other edges do`);
        }
      });
    }
    return found;
  }

  /** The turn of the face across an edge, or null if the originals do not meet like that. */
  private turnAcross(face: number, corner: number, turn: number, other: Side): number | null {
    const [mine, theirs] = [this.source(face), this.source(other.face)];
    const from = mine[(corner + turn) % mine.length]!;
    const to = mine[(corner + turn + 1) % mine.length]!;
    const at = theirs.findIndex(
      (vertex, i) => vertex === to && theirs[(i + 1) % theirs.length] === from,
    );
    return at < 0 ? null : (at - other.corner + theirs.length) % theirs.length;
  }

  /** All distances between corners agree, and the outside is up. */
  private congruence(face: number, turn: number): string[] {
    const [flat, solid] = [this.flat(face), this.solid(face)];
    const size = flat.length;
    const tolerance = lengthTolerance * longestEdge(solid);
    let worst = 0;
    for (let i = 0; i < size; ++i) {
      for (let j = 0; j < i; ++j) {
        const original = distance(solid[(i + turn) % size]!, solid[(j + turn) % size]!);
        worst = Math.max(worst, Math.abs(distance(flat[i]!, flat[j]!) - original));
      }
    }
    const found: string[] = [];
    const source = this.net['faces_foldwright:source'][face]!;
    if (worst > tolerance)
      found.push(`face ${face} differs from its original ${source} by ${worst}`);
    if (signedArea(flat) <= 0) found.push(`face ${face} shows the inside of ${source}`);
    return found;
  }

  /** The assignment and the angle of a fold agree with the angle between the originals. */
  private foldOf(
    edge: number,
    face: number,
    corner: number,
    turns: (number | null)[],
    other: number,
  ): string[] {
    const [mine, theirs] = [this.solid(face), this.solid(other)];
    const start = corner + turns[face]!;
    const [from, to] = [mine[start % mine.length]!, mine[(start + 1) % mine.length]!];
    const wanted = foldAngle(mine, theirs, from, to);
    const tolerance = Math.max(angleTolerance(mine), angleTolerance(theirs));
    const angle = this.net.edges_foldAngle[edge];
    const assignment = this.net.edges_assignment[edge]!;
    if (typeof angle !== 'number') return [`edge ${edge} folds but has no angle`];
    const off = Math.abs(angle - wanted);
    // Folded by 180 degrees, rounding decides on which side.
    const found = Math.min(off, 360 - off) > tolerance + (assignment === 'F' ? flatAngle : 0);
    const sentences = found ? [`edge ${edge} folds by ${angle} instead of ${wanted} degrees`] : [];
    const flat = Math.abs(wanted);
    const right = angle < 0 ? 'M' : 'V';
    const fits = assignment === 'F' ? flat < flatAngle + tolerance : assignment === right;
    const sharp = assignment === 'F' || flat > flatAngle - tolerance;
    if (!fits || !sharp)
      sentences.push(`edge ${edge} of ${wanted} degrees is assigned ${assignment}`);
    return sentences;
  }
}

function checkHead({ key, model, nets }: FoldFile): string[] {
  const found: string[] = [];
  if (key.file_spec !== 1.2) found.push(`the version is ${key.file_spec}, not 1.2`);
  if (model.frame_unit !== 'mm') found.push(`the unit is ${model.frame_unit}, not mm`);
  if (!model.vertices_coords.every((point) => point.length === 3 && point.every(Number.isFinite))) {
    found.push('a vertex of the model is no point in space');
  }
  const ids = nets.map((net) => net['foldwright:piece']);
  if (new Set(ids).size !== ids.length) found.push('two pieces have the same number');
  return found;
}

/** Every face of the model in exactly one place of exactly one net. */
function checkCoverage({ model, nets }: FoldFile): string[] {
  const times = model.faces_vertices.map(() => 0);
  for (const net of nets) {
    for (const source of net['faces_foldwright:source']) times[source] = (times[source] ?? 0) + 1;
  }
  return times.flatMap((count, face) =>
    count === 1 ? [] : [`face ${face} of the model is in the nets ${count} times`],
  );
}

/** One sentence for each thing that is wrong with the nets of a FOLD file; none if it is good. */
export function checkNets(file: FoldFile): string[] {
  const nets = file.nets.flatMap((net) => new NetCheck(file, net).run());
  // The motion of a net that is wrong in itself says nothing.
  const motions = nets.length === 0 ? file.nets.flatMap((net) => checkMotion(file, net)) : [];
  return [...checkHead(file), ...checkCoverage(file), ...nets, ...motions];
}

/** One sentence for each thing that is wrong with a FOLD file, its key frame included. */
export function checkFold(file: FoldFile): string[] {
  return [...checkNets(file), ...checkKeyFrame(file)];
}
