/** Finds overlapping faces of a net by the area of their clipped intersection. */

type Point = number[];

interface Triangle {
  corners: Point[];
  /** +1, or -1 where a fan triangle of a concave polygon is to be taken away again. */
  sign: number;
}

interface Candidate {
  face: number;
  triangles: Triangle[];
  low: Point;
  high: Point;
}

function cross(o: Point, a: Point, b: Point): number {
  return (a[0]! - o[0]!) * (b[1]! - o[1]!) - (a[1]! - o[1]!) * (b[0]! - o[0]!);
}

/** Twice the signed area. */
function doubleArea(polygon: Point[]): number {
  let sum = 0;
  for (let i = 2; i < polygon.length; ++i) {
    sum += cross(polygon[0]!, polygon[i - 1]!, polygon[i]!);
  }
  return sum;
}

/** A polygon as a signed sum of counter-clockwise triangles, which holds for concave ones too. */
function fan(polygon: Point[]): Triangle[] {
  const triangles: Triangle[] = [];
  for (let i = 2; i < polygon.length; ++i) {
    const [a, b, c] = [polygon[0]!, polygon[i - 1]!, polygon[i]!];
    if (cross(a, b, c) >= 0) triangles.push({ corners: [a, b, c], sign: 1 });
    else triangles.push({ corners: [a, c, b], sign: -1 });
  }
  return triangles;
}

/** The part of a polygon on the left of the line from a to b (Sutherland and Hodgman 1974). */
function clip(polygon: Point[], a: Point, b: Point): Point[] {
  const result: Point[] = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length]!;
    const [sideP, sideQ] = [cross(a, b, p), cross(a, b, q)];
    if (sideP >= 0) result.push(p);
    if (sideP >= 0 !== sideQ >= 0) {
      const t = sideP / (sideP - sideQ);
      result.push([p[0]! + t * (q[0]! - p[0]!), p[1]! + t * (q[1]! - p[1]!)]);
    }
  });
  return result;
}

function commonArea(a: Triangle, b: Triangle): number {
  let polygon = a.corners;
  b.corners.forEach((corner, i) => {
    polygon = clip(polygon, corner, b.corners[(i + 1) % 3]!);
  });
  return (a.sign * b.sign * doubleArea(polygon)) / 2;
}

function candidateOf(polygon: Point[], face: number): Candidate {
  const [xs, ys] = [polygon.map((p) => p[0]!), polygon.map((p) => p[1]!)];
  return {
    face,
    triangles: fan(polygon),
    low: [Math.min(...xs), Math.min(...ys)],
    high: [Math.max(...xs), Math.max(...ys)],
  };
}

function overlapArea(a: Candidate, b: Candidate): number {
  let area = 0;
  for (const s of a.triangles) for (const t of b.triangles) area += commonArea(s, t);
  return area;
}

/**
 * Pairs of polygons that share more than `tolerance` of area. Sweeps over x and compares only
 * polygons whose boxes meet.
 */
export function overlappingPairs(polygons: Point[][], tolerance: number): [number, number][] {
  const sorted = polygons.map(candidateOf).sort((a, b) => a.low[0]! - b.low[0]!);
  const pairs: [number, number][] = [];
  let active: Candidate[] = [];
  for (const next of sorted) {
    active = active.filter((other) => other.high[0]! > next.low[0]!);
    for (const other of active) {
      if (other.high[1]! <= next.low[1]! || next.high[1]! <= other.low[1]!) continue;
      if (overlapArea(other, next) > tolerance) pairs.push([other.face, next.face]);
    }
    active.push(next);
  }
  return pairs;
}
