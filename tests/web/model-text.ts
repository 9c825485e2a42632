/** Models as OBJ files for tests of the command line. */

/** A mesh as the text of an OBJ file. */
export function objText({ vertices, faces }: { vertices: number[][]; faces: number[][] }): string {
  const points = vertices.map((point) => `v ${point.join(' ')}`);
  const polygons = faces.map((face) => `f ${face.map((vertex) => vertex + 1).join(' ')}`);
  return [...points, ...polygons, ''].join('\n');
}

/** A closed ring with waves on it, of 2 n^2 triangles: as much work as one wants. */
export function wavyRing(n: number): { vertices: number[][]; faces: number[][] } {
  const turn = (2 * Math.PI) / n;
  const vertices: number[][] = [];
  const faces: number[][] = [];
  for (let i = 0; i < n; ++i) {
    for (let j = 0; j < n; ++j) {
      const tube = 12 + 3 * Math.sin(5 * i * turn) * Math.cos(3 * j * turn);
      const ring = 40 + tube * Math.cos(j * turn);
      vertices.push([
        ring * Math.cos(i * turn),
        ring * Math.sin(i * turn),
        tube * Math.sin(j * turn),
      ]);
      const [right, up] = [(i + 1) % n, (j + 1) % n];
      faces.push([i * n + j, right * n + j, right * n + up]);
      faces.push([i * n + j, right * n + up, i * n + up]);
    }
  }
  return { vertices, faces };
}
