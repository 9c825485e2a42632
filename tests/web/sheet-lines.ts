/** What sheets have to show, from the model and the nets of a FOLD file. */
import type { FoldFile, ModelFrame, NetFrame } from './fold-file.js';
import type { PieceLines, Point } from './sheet-file.js';
import { cross, dot, minus, type Vector } from './vectors.js';

/** One side of a cut between two faces. */
export interface CutSide {
  from: Point;
  to: Point;
  /** The neighbouring face's third corner, unfolded across the edge. */
  apex: Point;
  /** Fold angle there in the model; degrees, valley positive. */
  angle: number;
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

/** The neighbour's third corner over the edge, and the angle between the faces. */
function across(
  model: ModelFrame,
  faces: Map<string, number>,
  [u, v]: [number, number],
): { along: number; out: number; angle: number } | null {
  const [face, other] = [faces.get(`${u} ${v}`), faces.get(`${v} ${u}`)];
  if (face === undefined || other === undefined) return null;
  const at = (vertex: number): Vector => model.vertices_coords[vertex]!;
  const third = (f: number): Vector =>
    at(model.faces_vertices[f]!.find((w) => w !== u && w !== v)!);
  const edge = minus(at(v), at(u));
  const length = Math.hypot(...edge);
  const far = minus(third(other), at(u));
  const along = dot(far, edge) / length;
  const normal = (f: number): Vector => {
    const [a, b, c] = model.faces_vertices[f]!.map(at);
    return cross(minus(b!, a!), minus(c!, a!));
  };
  const [n, m] = [normal(face), normal(other)];
  const sine = dot(cross(n, m), edge) / length;
  const angle = (-Math.atan2(sine, dot(n, m)) * 180) / Math.PI;
  return { along, out: Math.sqrt(Math.max(0, dot(far, far) - along * along)), angle };
}

/** The pieces of a file where they lie on their sheets. */
export function pieceLines(
  { model, nets }: FoldFile,
  drawn: Map<string, PieceLines>,
): { letter: string; frame: NetFrame; net: Lines }[] {
  const faces = facesByEdge(model);
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
        const beyond = across(model, faces, [source[i]!, source[next]!]);
        if (!beyond) return;
        const [from, to] = [place(a), place(corners[next]!)];
        const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
        const [ex, ey] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
        const { along, out, angle } = beyond;
        const apex: Point = [from[0] + along * ex + out * ey, from[1] + along * ey - out * ex];
        sides.push({ from, to, apex, angle });
      });
    });
    const ends = (edge: number): [Point, Point] => {
      const [a, b] = frame.edges_vertices[edge]!;
      return [place(a!), place(b!)];
    };
    return { letter, frame, net: { ends, sides } };
  });
}
