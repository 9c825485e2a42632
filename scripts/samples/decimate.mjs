/**
 * Edge collapse by quadric error (Garland and Heckbert 1997) for one half of a symmetric model:
 * what lies on x = 0 stays there, because every border vertex carries its mirror image's planes.
 * Slivers cost extra, so that the triangles stay pleasant to cut.
 */
import { Heap } from './heap.mjs';
import { addQuadrics, bestPoint, planeQuadric, quadricError, symmetrised } from './quadric.mjs';
import { add, dot, length, scale, subtract, triangleNormal } from './vector.mjs';

/** How much a collapse that leaves slivers costs more; found by looking at the models. */
const SLIVER_WEIGHT = 12;
/** A face may turn by up to about 70 degrees in a collapse, never over. */
const MIN_NORMAL_COSINE = 0.35;
/** 1 for an equilateral triangle, 0 for a degenerate one. */
export function quality(a, b, c) {
  const sides = [subtract(b, a), subtract(c, b), subtract(a, c)];
  const sum = sides.reduce((total, side) => total + dot(side, side), 0);
  return sum > 0 ? (2 * Math.sqrt(3) * length(triangleNormal(a, b, c))) / sum : 0;
}

/** The mesh while it shrinks. */
class Shrinking {
  constructor({ vertices, faces }) {
    this.points = vertices.map((p) => [...p]);
    this.faces = faces.map((f) => [...f]);
    this.facesOf = vertices.map(() => new Set());
    this.faces.forEach((face, f) => face.forEach((v) => this.facesOf[v].add(f)));
    this.onBorder = vertices.map((p) => p[0] === 0);
    this.stamp = new Int32Array(vertices.length);
    this.count = faces.length;
    this.quadrics = vertices.map(() => new Array(10).fill(0));
    for (const face of faces) {
      const q = planeQuadric(...face.map((v) => vertices[v]));
      for (const v of face) this.quadrics[v] = addQuadrics(this.quadrics[v], q);
    }
    vertices.forEach((_, v) => {
      if (this.onBorder[v]) this.quadrics[v] = symmetrised(this.quadrics[v]);
    });
  }

  neighbours(v) {
    const found = new Set();
    for (const f of this.facesOf[v]) for (const w of this.faces[f]) if (w !== v) found.add(w);
    return found;
  }

  /** Faces around a vertex, its mirror image's with them. */
  valence(v) {
    return this.facesOf[v].size * (this.onBorder[v] ? 2 : 1);
  }

  /** Link condition: the collapse keeps the surface a manifold, and the seam one line. */
  allowed(u, v) {
    const shared = [...this.facesOf[u]].filter((f) => this.facesOf[v].has(f));
    if (this.onBorder[u] && this.onBorder[v] && shared.length !== 1) return false;
    const [aroundU, aroundV] = [this.neighbours(u), this.neighbours(v)];
    const common = [...aroundU].filter((w) => aroundV.has(w));
    if (this.onBorder[u] !== this.onBorder[v]) {
      // An edge across one half between two points of the seam would double in the mirror.
      const [inner, outer] = this.onBorder[u] ? [aroundV, aroundU] : [aroundU, aroundV];
      const seam = this.onBorder[u] ? u : v;
      if ([...inner].some((w) => w !== seam && this.onBorder[w] && !outer.has(w))) return false;
    }
    // Two vertices of three faces each are the last tetrahedron.
    return common.length === shared.length && this.valence(u) + this.valence(v) > 6;
  }

  /** Cost and place of a collapse; null when it would turn a face over. */
  plan(u, v) {
    const middle = scale(add(this.points[u], this.points[v]), 0.5);
    let q = addQuadrics(this.quadrics[u], this.quadrics[v]);
    if (this.onBorder[u] || this.onBorder[v]) {
      if (!(this.onBorder[u] && this.onBorder[v])) q = symmetrised(q);
      middle[0] = 0;
    }
    const point = bestPoint(q, middle);
    if (middle[0] === 0) point[0] = 0;
    else if (point[0] < 0) return null;
    let worst = 1;
    for (const f of new Set([...this.facesOf[u], ...this.facesOf[v]])) {
      const face = this.faces[f];
      if (face.includes(u) && face.includes(v)) continue;
      const before = face.map((w) => this.points[w]);
      const after = face.map((w) => (w === u || w === v ? point : this.points[w]));
      const [n0, n1] = [triangleNormal(...before), triangleNormal(...after)];
      if (dot(n0, n1) < MIN_NORMAL_COSINE * length(n0) * length(n1)) return null;
      worst = Math.min(worst, quality(...after));
    }
    const span = dot(
      subtract(this.points[u], this.points[v]),
      subtract(this.points[u], this.points[v]),
    );
    // The tiny share of the length lets flat regions shrink evenly.
    const error = Math.max(0, quadricError(q, point)) + 1e-5 * span * span;
    const copies = this.onBorder[u] || this.onBorder[v] ? 1 : 2;
    return { cost: copies * error * (1 + SLIVER_WEIGHT * (1 - worst) ** 2), point, q };
  }

  collapse(u, v, { point, q }) {
    for (const f of this.facesOf[v]) {
      const face = this.faces[f];
      if (face.includes(u)) {
        for (const w of face) if (w !== v) this.facesOf[w].delete(f);
        this.faces[f] = null;
        this.count--;
      } else {
        face[face.indexOf(v)] = u;
        this.facesOf[u].add(f);
      }
    }
    this.facesOf[v].clear();
    this.points[u] = point;
    this.quadrics[u] = q;
    this.onBorder[u] ||= this.onBorder[v];
    this.stamp[u]++;
    this.stamp[v] = -1;
  }

  /** The live vertices and faces, numbered anew. */
  compact() {
    const number = new Map();
    const vertices = [];
    const renumber = (v) => {
      if (!number.has(v)) {
        number.set(v, vertices.length);
        vertices.push(this.points[v]);
      }
      return number.get(v);
    };
    const faces = this.faces.filter((face) => face !== null).map((face) => face.map(renumber));
    return { vertices, faces };
  }
}

/**
 * Shrinks one half of a symmetric triangle mesh to at most `target` faces.
 *
 * @returns {{vertices: number[][], faces: number[][]}}
 */
export function decimateHalf(mesh, target) {
  const shrinking = new Shrinking(mesh);
  const heap = new Heap();
  const offer = (u, v) => {
    const plan = shrinking.plan(u, v);
    if (plan) heap.push({ u, v, plan, stamps: [shrinking.stamp[u], shrinking.stamp[v]] });
  };
  mesh.vertices.forEach((_, u) => {
    for (const v of shrinking.neighbours(u)) if (u < v) offer(u, v);
  });
  while (shrinking.count > target && heap.items.length > 0) {
    const { u, v, plan: old, stamps } = heap.pop();
    if (shrinking.stamp[u] !== stamps[0] || shrinking.stamp[v] !== stamps[1]) continue;
    if (!shrinking.allowed(u, v)) continue;
    // Faces around the edge may have moved since it was priced.
    const plan = shrinking.plan(u, v);
    if (plan === null) continue;
    if (plan.cost > old.cost) {
      heap.push({ u, v, plan, stamps });
      continue;
    }
    shrinking.collapse(u, v, plan);
    for (const w of shrinking.neighbours(u)) offer(Math.min(u, w), Math.max(u, w));
  }
  return shrinking.compact();
}

/** Both halves welded along x = 0. */
export function mirrorHalf({ vertices, faces }) {
  const all = vertices.map((p) => [...p]);
  const twin = vertices.map((p, v) => (p[0] === 0 ? v : all.push([-p[0], p[1], p[2]]) - 1));
  const mirroredFaces = faces.map(([a, b, c]) => [twin[a], twin[c], twin[b]]);
  return { vertices: all, faces: [...faces, ...mirroredFaces] };
}
