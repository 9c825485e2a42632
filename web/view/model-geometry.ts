/** Triangles ready for the graphics card: every face has corners of its own, for flat shading. */
export interface FlatMesh {
  /** 3 per corner, moved and scaled so that the model just fits into the unit sphere. */
  positions: Float32Array;
  /** 3 per corner, of unit length; the same for all corners of a face. */
  normals: Float32Array;
  /** 2 per corner, along the face's plane: where a hatch lies. */
  uvs: Float32Array;
}

/** What a model around the origin fills while it turns around the upright axis. */
export interface Extent {
  /** Farthest up or down that it appears, seen from a little above. */
  up: number;
  /** Farthest from the axis. */
  reach: number;
  /** How much nearer than the middle that is seen which fills the view. */
  near: number;
  /** Whether it is longer from front to back than across. */
  deep: boolean;
}

/** Tiles of a hatch along the radius of the model. */
const tilesPerRadius = 14;

type Numbers = Float32Array | Float64Array;

/** Moves the middle of the bounding box to the origin and the farthest vertex to distance 1. */
function fitVertices(vertices: Numbers): Float32Array {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  vertices.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3]!, value);
    high[i % 3] = Math.max(high[i % 3]!, value);
  });
  const fitted = Float32Array.from(
    vertices,
    (value, i) => value - (low[i % 3]! + high[i % 3]!) / 2,
  );
  let radius = 0;
  for (let i = 0; i < fitted.length; i += 3) {
    radius = Math.max(radius, Math.hypot(fitted[i]!, fitted[i + 1]!, fitted[i + 2]!));
  }
  fitted.forEach((value, i) => {
    fitted[i] = value / (radius || 1);
  });
  return fitted;
}

/** Writes the unit normal of the triangle whose corners start at `at`, for each of its corners. */
function writeNormal(normals: Float32Array, p: Float32Array, at: number): void {
  const ax = p[at + 3]! - p[at]!;
  const ay = p[at + 4]! - p[at + 1]!;
  const az = p[at + 5]! - p[at + 2]!;
  const bx = p[at + 6]! - p[at]!;
  const by = p[at + 7]! - p[at + 1]!;
  const bz = p[at + 8]! - p[at + 2]!;
  const [x, y, z] = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
  // A triangle without area has no normal; any will do.
  const length = Math.sqrt(x * x + y * y + z * z) || 1;
  for (let i = at; i < at + 9; i += 3) {
    normals[i] = x / length;
    normals[i + 1] = y / length;
    normals[i + 2] = z / length;
  }
}

/** Writes the normals of all triangles. */
export function writeNormals(normals: Float32Array, positions: Float32Array): void {
  for (let at = 0; at < positions.length; at += 9) writeNormal(normals, positions, at);
}

/** The axis along which a normal points most: 0, 1 or 2. */
function mainAxis(normals: Float32Array, at: number): number {
  const [x, y, z] = [normals[at]!, normals[at + 1]!, normals[at + 2]!].map(Math.abs);
  if (x! >= y! && x! >= z!) return 0;
  return y! >= z! ? 1 : 2;
}

/**
 * Builds the triangles of a model once; colours come and go without it.
 *
 * @param vertices 3 per vertex
 * @param faces 3 per face, counter-clockwise from outside
 */
export function flatMesh(vertices: Numbers, faces: Int32Array): FlatMesh {
  const fitted = fitVertices(vertices);
  const positions = new Float32Array(3 * faces.length);
  const normals = new Float32Array(3 * faces.length);
  const uvs = new Float32Array(2 * faces.length);
  faces.forEach((vertex, corner) => {
    for (let axis = 0; axis < 3; ++axis) positions[3 * corner + axis] = fitted[3 * vertex + axis]!;
  });
  writeNormals(normals, positions);
  for (let corner = 0; corner < faces.length; ++corner) {
    // Seen along the axis that the face faces most, a hatch is stretched least.
    const away = mainAxis(normals, 3 * corner);
    uvs[2 * corner] = positions[3 * corner + ((away + 1) % 3)]! * tilesPerRadius;
    uvs[2 * corner + 1] = positions[3 * corner + ((away + 2) % 3)]! * tilesPerRadius;
  }
  return { positions, normals, uvs };
}

/**
 * How much room a model takes while it turns.
 *
 * @param positions 3 per corner, around the origin
 * @param height angle in radians from which it is seen, above the horizon
 */
export function extentOf(positions: Float32Array, height: number): Extent {
  const [sine, cosine] = [Math.sin(height), Math.cos(height)];
  let [up, reach, halfWidth, halfDepth] = [0, 0, 0, 0];
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i]!, positions[i + 1]!, positions[i + 2]!];
    const radius = Math.hypot(x, z);
    up = Math.max(up, Math.abs(y) * cosine + radius * sine);
    reach = Math.max(reach, radius);
    halfWidth = Math.max(halfWidth, Math.abs(x));
    halfDepth = Math.max(halfDepth, Math.abs(z));
  }
  // Little of a model is at its very front.
  return { up, reach, near: reach / 3, deep: halfDepth > halfWidth };
}
