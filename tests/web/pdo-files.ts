/** Writes files as Pepakura Designer does, for tests: a cube, or whatever bodies are given. */
import { zlibSync } from 'fflate';
import type { ModelFile } from '../../web/model/model-files.js';

/** Numbers that follow each other without gaps, little-endian. */
class Writer {
  private readonly bytes: number[] = [];

  /** @param shift added to each byte of a text */
  constructor(
    private readonly isWide: boolean,
    private readonly shift: number,
  ) {}

  raw(values: Iterable<number>): this {
    for (const value of values) this.bytes.push(value & 255);
    return this;
  }

  number(kind: 'Uint32' | 'Int32' | 'Float32' | 'Float64', ...values: number[]): this {
    for (const value of values) {
      const view = new DataView(new ArrayBuffer(kind === 'Float64' ? 8 : 4));
      view[`set${kind}`](0, value, true);
      this.raw(new Uint8Array(view.buffer));
    }
    return this;
  }

  u32(...values: number[]): this {
    return this.number('Uint32', ...values);
  }

  i32(...values: number[]): this {
    return this.number('Int32', ...values);
  }

  f64(...values: number[]): this {
    return this.number('Float64', ...values);
  }

  bool(value: boolean): this {
    return this.raw([value ? 1 : 0]);
  }

  text(text: string): this {
    const shifted = (byte: number): number => byte + this.shift;
    if (!this.isWide) {
      const letters = [...new TextEncoder().encode(text)].map(shifted);
      return this.u32(letters.length + 1).raw([...letters, 0]);
    }
    const units = Uint16Array.from(`${text}\0`, (letter) => letter.charCodeAt(0));
    const bytes = [...new Uint8Array(units.buffer)].map(shifted);
    return this.u32(bytes.length).raw(bytes);
  }

  get file(): Uint8Array {
    return Uint8Array.from(this.bytes);
  }
}

export interface PdoPictureSpec {
  width: number;
  height: number;
  /** 3 per pixel, from above. */
  rgb: Uint8Array;
}

export interface PdoBody {
  isVisible?: boolean;
  vertices: readonly (readonly number[])[];
  faces: readonly (readonly number[])[];
  /** Of faces; all of the first material if it is left out. */
  materials?: readonly number[];
  /** Pairs of faces between which the net goes on. */
  joined?: readonly (readonly [number, number])[];
  /** Height of the flaps that the first face of each cut edge bears; none if it is left out. */
  flap?: number;
}

export interface PdoSpec {
  version?: 4 | 5 | 6;
  isWide?: boolean;
  shift?: number;
  lock?: number;
  bodies?: readonly PdoBody[];
  materials?: readonly { name: string; colour: readonly number[]; picture?: PdoPictureSpec }[];
  /** Null for a model that was never unfolded. */
  pattern?: { scale: number; parts: readonly (readonly [number, number])[] } | null;
}

/** A cube of side 10 as Pepakura has it, faces outwards; its net is a cross. */
export const cube: PdoBody = {
  vertices: [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2].map((c) => 10 * c)),
  faces: [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ],
  joined: [
    [0, 2],
    [0, 3],
    [0, 4],
    [0, 5],
    [1, 2],
  ],
};

/** The cube in two nets of three faces each. */
export const halves: PdoBody = {
  ...cube,
  flap: 6,
  joined: [
    [0, 2],
    [0, 4],
    [1, 3],
    [1, 5],
  ],
};

export const halvesFile: PdoSpec = {
  bodies: [halves],
  pattern: {
    scale: 3,
    parts: [
      [70, 70],
      [70, 70],
    ],
  },
};

/** Edges of a body with the faces on their sides, the first one in its direction. */
function edgesOf({ faces }: PdoBody): { faces: [number, number]; vertices: [number, number] }[] {
  const found = new Map<string, { faces: [number, number]; vertices: [number, number] }>();
  faces.forEach((face, number) => {
    face.forEach((vertex, i) => {
      const next = face[(i + 1) % face.length]!;
      const other = found.get(`${next} ${vertex}`);
      if (other) other.faces[1] = number;
      else found.set(`${vertex} ${next}`, { faces: [number, -1], vertices: [vertex, next] });
    });
  });
  return [...found.values()];
}

function isJoined({ joined = [] }: PdoBody, [a, b]: readonly [number, number]): boolean {
  return joined.some(([c, d]) => (a === c && b === d) || (a === d && b === c));
}

function writeBody(out: Writer, body: PdoBody): void {
  const { vertices, faces, materials, isVisible = true, flap = 0 } = body;
  const edges = edgesOf(body);
  const bearsFlap = (face: number, vertex: number): boolean => {
    const edge = edges.find((one) => one.faces[0] === face && one.vertices[0] === vertex);
    return flap > 0 && edge !== undefined && !isJoined(body, edge.faces);
  };
  out.text('body').bool(isVisible).u32(vertices.length);
  for (const vertex of vertices) out.f64(...vertex);
  out.u32(faces.length);
  faces.forEach((face, number) => {
    out
      .i32(materials?.[number] ?? 0, 0)
      .f64(0, 0, 1, 0)
      .u32(face.length);
    face.forEach((vertex, i) => {
      out
        .i32(vertex)
        .f64(0, 0, i % 2, i >> 1)
        .bool(bearsFlap(number, vertex));
      out.f64(flap, 0.7, 0.7).raw(new Uint8Array(24));
    });
  });
  out.u32(edges.length);
  for (const edge of edges) {
    out.i32(...edge.faces, ...edge.vertices).bool(isJoined(body, edge.faces));
    out.raw(new Uint8Array(5));
  }
}

function writeHeader(
  out: Writer,
  spec: Required<Pick<PdoSpec, 'version' | 'lock' | 'shift'>>,
): void {
  const { version, lock, shift } = spec;
  if (version > 4) out.u32(0).u32(shift);
  out.text('en-US').text('').u32(lock);
  if (version === 6) out.raw([0, 0]);
  out.text('0123456789abcdef0123456789abcdef');
  if (version === 6) out.u32(0);
  if (version === 5) out.raw([0, 0]);
  out.f64(10, 5, 5, 5);
}

function writePattern(
  out: Writer,
  version: number,
  pattern: NonNullable<PdoSpec['pattern']>,
): void {
  out.f64(pattern.scale).bool(false).f64(0, 0, 100, 100).u32(pattern.parts.length);
  for (const size of pattern.parts) {
    out.u32(0).f64(0, 0, ...size);
    if (version > 4) out.text('part');
    out.u32(2);
    out.bool(false).u32(0).bool(true).i32(0, 0).bool(false);
    out.bool(false).u32(0).bool(true).i32(0, 0).bool(true).i32(1, 1);
  }
  // A text and no pictures.
  out.u32(1).f64(0, 0, 10, 10, 2).raw([0, 0, 0, 0]).u32(12).text('Arial').u32(1).text('A cube');
  out.u32(0, 0);
}

/** A PDO file; what follows behind the sheets is left out, as nobody reads it. */
export function pdoFile(spec: PdoSpec = {}): ModelFile {
  const { version = 5, isWide = version === 6, shift = version === 4 ? 0 : 200, lock = 0 } = spec;
  const { bodies = [cube], pattern = { scale: 2, parts: [[90, 70]] } } = spec;
  const { materials = [{ name: 'paper', colour: [1, 0.5, 0] }] } = spec;
  const out = new Writer(isWide, shift);
  out.raw(new TextEncoder().encode('version 3\n')).u32(version, isWide ? 1 : 0, 300);
  writeHeader(out, { version, lock, shift });
  out.u32(bodies.length);
  for (const body of bodies) writeBody(out, body);
  out.u32(materials.length);
  for (const { name, colour, picture } of materials) {
    const faint = [0.5, 0.5, 0.5, 1];
    out.text(name).number('Float32', ...faint, ...colour, 1, ...faint, ...faint, ...faint);
    out.bool(picture !== undefined);
    if (!picture) continue;
    const packed = zlibSync(picture.rgb);
    out.u32(picture.width, picture.height, packed.length).raw(packed);
  }
  out.bool(pattern !== null);
  if (pattern) writePattern(out, version, pattern);
  return { name: 'cube.pdo', bytes: out.file };
}
