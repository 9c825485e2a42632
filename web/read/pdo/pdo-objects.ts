/** The bodies of a PDO file: vertices, faces with all that belongs to their corners, and edges. */
import type { PdoBytes } from './pdo-bytes.js';
import { skipText } from './pdo-strings.js';

const bytesPerVertex = 24;
const bytesPerFace = 44;
const bytesPerCorner = 85;
const bytesPerEdge = 22;

/** Lists by corner, of all faces in a row. What is said of an edge belongs to the one that begins at the corner. */
export interface PdoCorners {
  vertices: number[];
  /** 2 per corner: places in pictures, to the right and down. */
  places: number[];
  /** Height in mm of the flap at the edge, if its two sides are not joined; 0 for none. */
  flaps: number[];
}

export interface PdoObject {
  isVisible: boolean;
  /** 3 per vertex. */
  positions: Float64Array;
  /** Per face: number of its material, -1 for none. */
  materials: number[];
  /** Per face: where its corners begin; and their number at last. */
  firstCorners: number[];
  corners: PdoCorners;
  /**
   * 4 per edge across which the net goes on: its two faces, and its two vertices as they follow each other in the
   * first face.
   */
  joined: Int32Array;
}

function readPositions(bytes: PdoBytes): Float64Array {
  const count = bytes.count(bytesPerVertex);
  return Float64Array.from({ length: 3 * count }, () => bytes.f64());
}

function readCorner(bytes: PdoBytes, { vertices, places, flaps }: PdoCorners): void {
  vertices.push(bytes.i32());
  bytes.skip(16); // place on paper
  places.push(bytes.f64(), bytes.f64());
  const hasFlap = bytes.bool();
  const height = bytes.f64();
  flaps.push(hasFlap && height > 0 ? height : 0);
  bytes.skip(40); // angles and colours of the flap
}

function readFaces(bytes: PdoBytes): Pick<PdoObject, 'materials' | 'firstCorners' | 'corners'> {
  const [materials, firstCorners]: number[][] = [[], [0]];
  const corners: PdoCorners = { vertices: [], places: [], flaps: [] };
  for (let left = bytes.count(bytesPerFace); left > 0; --left) {
    materials!.push(bytes.i32());
    bytes.skip(4 + 32); // part and plane
    for (let more = bytes.count(bytesPerCorner); more > 0; --more) readCorner(bytes, corners);
    firstCorners!.push(corners.vertices.length);
  }
  return { materials: materials!, firstCorners: firstCorners!, corners };
}

/** Those edges at which the net goes on. */
function readJoined(bytes: PdoBytes): Int32Array {
  const count = bytes.count(bytesPerEdge);
  const joined = new Int32Array(4 * count);
  let found = 0;
  for (let left = count; left > 0; --left) {
    for (let i = 0; i < 4; ++i) joined[found + i] = bytes.i32();
    if (bytes.bool()) found += 4;
    bytes.skip(5);
  }
  return joined.slice(0, found);
}

/** @throws BrokenPdo */
export function readObjects(bytes: PdoBytes): PdoObject[] {
  // A name, whether it is seen, and three counts.
  return Array.from({ length: bytes.count(17) }, () => {
    skipText(bytes);
    const isVisible = bytes.bool();
    const positions = readPositions(bytes);
    return { isVisible, positions, ...readFaces(bytes), joined: readJoined(bytes) };
  });
}
