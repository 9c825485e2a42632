/** Finds the edges between faces once, and the borders between parts for any labels of the faces. */
export class PartBorders {
  /** 2 per edge: a corner of each of its faces, at which it starts or ends. */
  private readonly edges: number[] = [];

  /** @param faces 3 vertices per face */
  constructor(faces: Int32Array) {
    const corners = new Map<number, number>();
    const count = faces.reduce((most, vertex) => Math.max(most, vertex), 0) + 1;
    faces.forEach((from, corner) => {
      const first = corner - (corner % 3);
      const to = faces[first + ((corner + 1) % 3)]!;
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
   * Lines along the borders, 6 numbers each.
   *
   * @param positions 3 per corner of a face
   */
  lines(labels: Int32Array, positions: Float32Array): Float32Array {
    const part = (corner: number): number => labels[Math.floor(corner / 3)]!;
    const lines: number[] = [];
    for (let edge = 0; edge < this.edges.length; edge += 2) {
      const corner = this.edges[edge]!;
      if (part(corner) === part(this.edges[edge + 1]!)) continue;
      const next = corner - (corner % 3) + ((corner + 1) % 3);
      for (const end of [corner, next]) {
        lines.push(positions[3 * end]!, positions[3 * end + 1]!, positions[3 * end + 2]!);
      }
    }
    return new Float32Array(lines);
  }
}
