/** What sheets have to show, from the model and the nets of a FOLD file. */
import type { FoldFile, ModelFrame, NetFrame } from './fold-file.js';
import type { PieceLines, Point } from './sheet-file.js';
import { cross, dot, minus, type Vector } from './vectors.js';

/** One side of a seam: cut edges in a straight line between the same two panels. */
export interface CutSide {
  from: Point;
  to: Point;
  /** The edges, one after the other. */
  edges: [Point, Point][];
  /** The neighbouring panel's triangles, unfolded across the edge. */
  beyond: Point[][];
  /** Fold angle there in the model; degrees, valley positive. */
  angle: number;
  /** Faces of the model that the first edge lies between. */
  face: number;
  other: number;
}

export interface Lines {
  ends(edge: number): [Point, Point];
  sides: CutSide[];
}

const letterOf = (piece: number): string =>
  (piece < 26 ? '' : letterOf(Math.floor(piece / 26) - 1)) + String.fromCharCode(65 + (piece % 26));

/** Per directed edge of the model: the face on its left. */
function facesByEdge({ faces_vertices }: ModelFrame): Map<string, number> {
  const faces = new Map<string, number>();
  faces_vertices.forEach((corners, face) => {
    corners.forEach((v, i) => faces.set(`${v} ${corners[(i + 1) % corners.length]}`, face));
  });
  return faces;
}

/**
 * How far a net was moved to its place: flaps hide the extremes of the net, so that of all moves that
 * bring its first cut edge onto the cut line the one is taken that brings most others there, too.
 */
function offset(frame: NetFrame, { cuts }: PieceLines): Point {
  const key = (x: number, y: number): string => `${Math.round(50 * x)} ${Math.round(50 * y)}`;
  const near = new Set<string>();
  for (const [x, y] of cuts.flat()) {
    for (const i of [-0.02, 0, 0.02]) for (const j of [-0.02, 0, 0.02]) near.add(key(x + i, y + j));
  }
  const starts = frame.edges_vertices.flatMap(([v], e) =>
    frame.edges_assignment[e] === 'B' ? [frame.vertices_coords[v!]!] : [],
  );
  let best: Point = [0, 0];
  let most = -1;
  for (const [x, y] of cuts.flat()) {
    const [dx, dy] = [x - starts[0]![0]!, y - starts[0]![1]!];
    const found = starts.filter(([u, v]) => near.has(key(u! + dx, v! + dy))).length;
    if (found > most) [best, most] = [[dx, dy], found];
  }
  return best;
}

type EdgeFaces = Map<string, number>;

/** The angle between the faces at an edge of the first one; degrees, valley positive. */
function foldAngle(
  { vertices_coords, faces_vertices }: ModelFrame,
  [face, other]: [number, number],
  [u, v]: [number, number],
): number {
  const at = (vertex: number): Vector => vertices_coords[vertex]!;
  const edge = minus(at(v), at(u));
  const normal = (f: number): Vector => {
    const [a, b, c] = faces_vertices[f]!.map(at);
    return cross(minus(b!, a!), minus(c!, a!));
  };
  const [n, m] = [normal(face), normal(other)];
  return (-Math.atan2(dot(cross(n, m), edge) / Math.hypot(...edge), dot(n, m)) * 180) / Math.PI;
}

/** Per face of the model: the lowest face of its panel. */
function panelsOf(model: ModelFrame, faces: EdgeFaces): number[] {
  const panel = model.faces_vertices.map(() => -1);
  model.faces_vertices.forEach((_, seed) => {
    if (panel[seed] !== -1) return;
    const open = [seed];
    panel[seed] = seed;
    for (let face = open.pop(); face !== undefined; face = open.pop()) {
      const corners = model.faces_vertices[face]!;
      corners.forEach((u, i) => {
        const v = corners[(i + 1) % corners.length]!;
        const other = faces.get(`${v} ${u}`);
        if (other === undefined || panel[other] !== -1) return;
        if (Math.abs(foldAngle(model, [face, other], [u, v])) >= 0.001) return;
        panel[other] = seed;
        open.push(other);
      });
    }
  });
  return panel;
}

/** The panel of a face, unfolded across the edge from `u` to `v` that lies on the sheet. */
function unfolded(
  { vertices_coords, faces_vertices }: ModelFrame,
  members: number[],
  [u, v]: [number, number],
  [from, to]: [Point, Point],
): Point[][] {
  const at = (vertex: number): Vector => vertices_coords[vertex]!;
  const edge = minus(at(v), at(u));
  const length = Math.hypot(...edge);
  const off = (vertex: number): { along: number; away: Vector } => {
    const far = minus(at(vertex), at(u));
    const along = dot(far, edge) / length;
    const [x, y, z] = edge.map((step) => (along * step) / length);
    return { along, away: minus(far, [x!, y!, z!]) };
  };
  const corners = members.flatMap((face) => faces_vertices[face]!);
  const farthest = corners.reduce((best, w) =>
    Math.hypot(...off(w).away) > Math.hypot(...off(best).away) ? w : best,
  );
  const into = off(farthest).away;
  const depth = Math.hypot(...into);
  const [ex, ey] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  return members.map((face) =>
    faces_vertices[face]!.map((w): Point => {
      const { along, away } = off(w);
      const out = dot(away, into) / depth;
      return [from[0] + along * ex + out * ey, from[1] + along * ey - out * ex];
    }),
  );
}

/** Whether the second side goes on from the first in a straight line between the same panels. */
function continues(first: CutSide, second: CutSide, panel: number[]): boolean {
  if (panel[first.face] !== panel[second.face]) return false;
  if (panel[first.other] !== panel[second.other]) return false;
  const [a, b, c] = [first.from, first.to, second.to];
  if (Math.hypot(b[0] - second.from[0], b[1] - second.from[1]) > 1e-6) return false;
  const away = (c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0]);
  const ahead = (c[0] - b[0]) * (b[0] - a[0]) + (c[1] - b[1]) * (b[1] - a[1]);
  return ahead > 0 && Math.abs(away) < 0.01 * Math.hypot(c[0] - a[0], c[1] - a[1]);
}

/** Edges that go on from each other as one. */
function merged(sides: CutSide[], panel: number[]): CutSide[] {
  const runs = [...sides];
  for (let i = 0; i < runs.length;) {
    const next = runs.findIndex((side) => side !== runs[i] && continues(runs[i]!, side, panel));
    if (next < 0) {
      ++i;
      continue;
    }
    const { to, edges } = runs[next]!;
    runs[i] = { ...runs[i]!, to, edges: [...runs[i]!.edges, ...edges] };
    runs.splice(next, 1);
    if (next < i) --i;
  }
  return runs;
}

/** The pieces of a file where they lie on their sheets. */
export function pieceLines(
  { model, nets }: FoldFile,
  drawn: Map<string, PieceLines>,
): { letter: string; frame: NetFrame; net: Lines }[] {
  const faces = facesByEdge(model);
  const panel = panelsOf(model, faces);
  return nets.map((frame) => {
    const letter = letterOf(frame['foldwright:piece']);
    const lines = drawn.get(letter);
    const [dx, dy] = lines ? offset(frame, lines) : [0, 0];
    const place = (vertex: number): Point => {
      const [x, y] = frame.vertices_coords[vertex]!;
      return [x! + dx, y! + dy];
    };
    const cut = new Set(
      frame.edges_vertices.flatMap(([a, b], e) =>
        frame.edges_assignment[e] === 'B' ? [`${a} ${b}`, `${b} ${a}`] : [],
      ),
    );
    const sides: CutSide[] = [];
    frame.faces_vertices.forEach((corners, f) => {
      const source = model.faces_vertices[frame['faces_foldwright:source'][f]!]!;
      corners.forEach((a, i) => {
        const next = (i + 1) % corners.length;
        if (!cut.has(`${a} ${corners[next]}`)) return;
        const [u, v] = [source[i]!, source[next]!];
        const [face, other] = [faces.get(`${u} ${v}`), faces.get(`${v} ${u}`)];
        if (face === undefined || other === undefined) return;
        const [from, to] = [place(a), place(corners[next]!)];
        const members = panel.flatMap((seed, at) => (seed === panel[other] ? [at] : []));
        const beyond = unfolded(model, members, [u, v], [from, to]);
        const angle = foldAngle(model, [face, other], [u, v]);
        sides.push({ from, to, edges: [[from, to]], beyond, angle, face, other });
      });
    });
    const ends = (edge: number): [Point, Point] => {
      const [a, b] = frame.edges_vertices[edge]!;
      return [place(a!), place(b!)];
    };
    return { letter, frame, net: { ends, sides: merged(sides, panel) } };
  });
}
