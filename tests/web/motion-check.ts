/**
 * Judges the motions of a FOLD file: do they begin flat, and do they end in the model? Lays faces in
 * space one beside the other, by lengths and angles alone, and shares no code with what moves faces
 * on screen.
 */
import type { FoldFile, FoldMotion, ModelFrame, NetFrame } from './fold-file.js';
import { cross, dot, length, minus, type Vector } from './vectors.js';

/** Of a corner of the folded net from its place, relative to the size of the model. */
const placeTolerance = 1e-6;
/** Degrees that edges within a panel may be bent by; their motion leaves them flat. */
const flatAngle = 1e-3;

const unit = (a: Vector): Vector => a.map((value) => value / length(a));
/** a + x u + y v. */
const point = (a: Vector, x: number, u: Vector, y: number, v: Vector): Vector =>
  a.map((value, i) => value + x * u[i]! + y * v[i]!);

/** Whether the keys are what a motion consists of; one sentence for each that is not. */
function checkKeys(net: NetFrame, { root, t, angles, certified }: FoldMotion): string[] {
  const found: string[] = [];
  const edges = net.edges_vertices.length;
  if (!net.faces_vertices[root]) found.push(`there is no face ${root} that could stay`);
  const ascending = t.every((time, key) => key === 0 || time > t[key - 1]!);
  if (!ascending || t[0] !== 0 || t.at(-1) !== 1) found.push(`its times are ${t.join(', ')}`);
  if (certified !== true) found.push('it is not certified');
  if (angles.length !== t.length) found.push(`it has ${t.length} times, but ${angles.length} keys`);
  angles.forEach((key, at) => {
    if (key.length !== edges) found.push(`key ${at} has ${key.length} angles for ${edges} edges`);
  });
  return found;
}

/** Cuts have no angles; the first key is flat and the last one folded; none goes beyond. */
function checkAngles(net: NetFrame, { angles }: FoldMotion): string[] {
  const found: string[] = [];
  net.edges_assignment.forEach((assignment, edge) => {
    const full = net.edges_foldAngle[edge];
    const way = angles.map((key) => key[edge]);
    if (assignment === 'B') {
      if (way.some((angle) => angle !== null)) found.push(`cut edge ${edge} has an angle`);
      return;
    }
    const [first, last] = [way[0], way.at(-1)];
    if (typeof full !== 'number' || typeof last !== 'number') found.push(`edge ${edge} has none`);
    else if (first !== 0) found.push(`edge ${edge} begins at ${first} degrees`);
    else if (Math.abs(last - full) > (assignment === 'F' ? flatAngle : 0)) {
      found.push(`edge ${edge} ends at ${last} instead of ${full} degrees`);
    }
    const beyond = way.some((angle) => {
      const share = Number(angle) / Number(full);
      return assignment !== 'F' && !(share >= -1e-9 && share <= 1 + 1e-9);
    });
    if (beyond) found.push(`edge ${edge} is folded further than its ${full} degrees`);
  });
  return found;
}

/** A face that lies beside another one along an edge that folds. */
interface Joint {
  face: number;
  edge: number;
}

function jointsOf(net: NetFrame): Joint[][] {
  const facesAt = new Map<string, number[]>();
  const key = (ends: number[]): string => [...ends].sort((a, b) => a - b).join();
  net.faces_vertices.forEach((face, f) => {
    face.forEach((from, i) => {
      const side = key([from, face[(i + 1) % face.length]!]);
      facesAt.set(side, [...(facesAt.get(side) ?? []), f]);
    });
  });
  const joints = net.faces_vertices.map((): Joint[] => []);
  net.edges_vertices.forEach((ends, edge) => {
    const [a, b] = facesAt.get(key(ends)) ?? [];
    if (net.edges_assignment[edge] === 'B' || a === undefined || b === undefined) return;
    joints[a]!.push({ face: b, edge });
    joints[b]!.push({ face: a, edge });
  });
  return joints;
}

/** Corners of the faces in space, by vertex. */
type Placed = Map<number, Vector>;

function normalOf(net: NetFrame, face: number, placed: Placed): Vector {
  const [a, b, c] = net.faces_vertices[face]!.map((vertex) => placed.get(vertex)!);
  return unit(cross(minus(b!, a!), minus(c!, a!)));
}

/** Lays a face into space beside one that is placed: its own lengths, turned up by the angle. */
function placeBeside(net: NetFrame, from: number, beside: Placed, { face, edge }: Joint): Placed {
  const ends = net.edges_vertices[edge]!;
  const [p, q] = ends.map((vertex) => net.vertices_coords[vertex]!);
  const [start, end] = ends.map((vertex) => beside.get(vertex)!);
  const along = unit(minus(end!, start!));
  const normal = normalOf(net, from, beside);
  const flatAlong = unit(minus(q!, p!));
  const flatAside = [-flatAlong[1]!, flatAlong[0]!];
  const angle = (Number(net.edges_foldAngle[edge]) * Math.PI) / 180;
  const heights = net.faces_vertices[face]!.map((vertex) =>
    dot(minus(net.vertices_coords[vertex]!, p!), flatAside),
  );
  // Up is where the normal looks; away from the edge on this side of it is up's shadow.
  const side = Math.sign(heights.reduce((sum, height) => sum + height, 0));
  const flat = cross(normal, along).map((value) => value * side);
  const aside = point([0, 0, 0], Math.cos(angle), flat, Math.sin(angle), normal);
  return new Map(
    net.faces_vertices[face]!.map((vertex, i) => {
      const x = dot(minus(net.vertices_coords[vertex]!, p!), flatAlong);
      return [vertex, point(start!, x, along, side * heights[i]!, aside)];
    }),
  );
}

/** How far the corners of a placed face are from its original, in the best order of its corners. */
function distanceFrom(original: Vector[], corners: Vector[]): number {
  const turns = corners.map((_, turn) =>
    Math.max(...corners.map((p, i) => length(minus(p, original[(i + turn) % original.length]!)))),
  );
  return Math.min(...turns);
}

/** The ways to lay the root onto its original: more than one where it is symmetric. */
function waysOnto(net: NetFrame, root: number, original: Vector[], tolerance: number): Placed[] {
  const vertices = net.faces_vertices[root]!;
  const sides = (corners: Vector[]): number[] =>
    corners.map((corner, i) => length(minus(corners[(i + 1) % corners.length]!, corner)));
  const wanted = sides(vertices.map((vertex) => net.vertices_coords[vertex]!));
  return original.flatMap((_, turn) => {
    const corners = [...original.slice(turn), ...original.slice(0, turn)];
    const fits = sides(corners).every((side, i) => Math.abs(side - wanted[i]!) < tolerance);
    return fits ? [new Map(vertices.map((vertex, i) => [vertex, corners[i]!]))] : [];
  });
}

/** The diagonal of the model's box. */
function sizeOf({ vertices_coords }: ModelFrame): number {
  const extents = [0, 1, 2].map((axis) => {
    const values = vertices_coords.map((p) => p[axis]!);
    return Math.max(...values) - Math.min(...values);
  });
  return length(extents);
}

/** Folds the net up from its root, which is laid onto its original, and compares all faces. */
function checkFolded(file: FoldFile, net: NetFrame, root: number): string[] {
  const original = (face: number): Vector[] =>
    file.model.faces_vertices[net['faces_foldwright:source'][face]!]!.map(
      (vertex) => file.model.vertices_coords[vertex]!,
    );
  const tolerance = placeTolerance * sizeOf(file.model);
  const joints = jointsOf(net);
  const distances = waysOnto(net, root, original(root), tolerance).map((rootPlaced) => {
    let worst = 0;
    const places = new Map([[root, rootPlaced]]);
    for (const [face, placed] of places) {
      for (const joint of joints[face]!) {
        if (places.has(joint.face)) continue;
        const next = placeBeside(net, face, placed, joint);
        places.set(joint.face, next);
        worst = Math.max(worst, distanceFrom(original(joint.face), [...next.values()]));
      }
    }
    return worst;
  });
  const least = Math.min(...distances);
  return least > tolerance ? [`folded, it is ${least} mm off the model`] : [];
}

/** One sentence for each thing that is wrong with a net's motion; none if it is good, or has none. */
export function checkMotion(file: FoldFile, net: NetFrame): string[] {
  const motion = net['foldwright:motion'];
  if (!motion) return [];
  const keys = checkKeys(net, motion);
  const found =
    keys.length > 0 ? keys : [...checkAngles(net, motion), ...checkFolded(file, net, motion.root)];
  return found.map((sentence) => `piece ${net['foldwright:piece']}: motion: ${sentence}`);
}
