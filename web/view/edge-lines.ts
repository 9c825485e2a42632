/** Finds the edges between faces once, and lines along any of them. */
export class EdgeLines {
  /** 2 per edge: the corners at which its faces begin to walk it. */
  private readonly edges: number[] = [];

  /** @param faces 3 vertices per face */
  constructor(faces: Int32Array) {
    const corners = new Map<number, number>();
    const count = faces.reduce((most, vertex) => Math.max(most, vertex), 0) + 1;
    faces.forEach((from, corner) => {
      const to = faces[nextCorner(corner)]!;
      const key = Math.min(from, to) * count + Math.max(from, to);
      const other = corners.get(key);
      if (other === undefined) {
        corners.set(key, corner);
        return;
      }
      this.edges.push(corner, other);
    });
  }

  /**
   * Lines along both sides of some edges: the corners at which each starts and ends.
   *
   * @param wanted of the corners at which the faces of an edge begin to walk it
   */
  along(wanted: (a: number, b: number) => boolean): Uint32Array {
    const ends: number[] = [];
    for (let edge = 0; edge < this.edges.length; edge += 2) {
      const [a, b] = [this.edges[edge]!, this.edges[edge + 1]!];
      if (wanted(a, b)) ends.push(a, nextCorner(a), b, nextCorner(b));
    }
    return Uint32Array.from(ends);
  }
}

/** The corner after this one in its face. */
export function nextCorner(corner: number): number {
  return corner - (corner % 3) + ((corner + 1) % 3);
}
