/** An edge between two faces: which, and the corner of the first face at which it starts. */
interface SharedEdge {
  corner: number;
  first: number;
  second: number;
}

/** Finds the edges between faces once, and the borders between parts for any labels of the faces. */
export class PartBorders {
  private readonly edges: SharedEdge[] = [];

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
      this.edges.push({ corner, first: Math.floor(corner / 3), second: Math.floor(other / 3) });
    });
  }

  /**
   * Lines along the borders, 6 numbers each.
   *
   * @param positions 3 per corner of a face
   */
  lines(labels: Int32Array, positions: Float32Array): Float32Array {
    const borders = this.edges.filter(({ first, second }) => labels[first] !== labels[second]);
    const lines = new Float32Array(6 * borders.length);
    borders.forEach(({ corner, first }, index) => {
      const next = 3 * first + ((corner + 1) % 3);
      lines.set(positions.subarray(3 * corner, 3 * corner + 3), 6 * index);
      lines.set(positions.subarray(3 * next, 3 * next + 3), 6 * index + 3);
    });
    return lines;
  }
}
