/** Chunk types and the mark of the format, as its specification has them (glTF 2.0, section 4.4). */
const magic = 0x46546c67;
const version = 2;
const jsonChunk = 0x4e4f534a;
const binaryChunk = 0x004e4942;

/** Bytes that a chunk is filled up to, and what with. */
const alignment = 4;
const space = 0x20;

const float = 5126;
const arrayBuffer = 34962;

type AccessorType = 'SCALAR' | 'VEC3' | 'VEC4';
const widths: Readonly<Record<AccessorType, number>> = { SCALAR: 1, VEC3: 3, VEC4: 4 };

interface Accessor {
  bufferView: number;
  byteOffset: number;
  componentType: typeof float;
  count: number;
  type: AccessorType;
  min?: number[];
  max?: number[];
}

/** A run of numbers in the file that is read in the same way. */
interface View {
  numbers: number[];
  /** Of a view that the graphics card reads. */
  layout?: { target: typeof arrayBuffer; byteStride: number };
}

/** The numbers of a glTF file: corners of meshes in one view, keys of animations in another. */
export class GlbNumbers {
  private readonly accessors: Accessor[] = [];
  private readonly views: View[] = [
    { numbers: [], layout: { target: arrayBuffer, byteStride: 12 } },
    { numbers: [] },
  ];

  /** Takes corners of triangles in, 3 numbers each; the index to name them by. */
  addCorners(values: readonly number[]): number {
    return this.add(0, 'VEC3', values, true);
  }

  /** Takes the seconds of keys in, ascending; the index to name them by. */
  addSeconds(values: readonly number[]): number {
    return this.add(1, 'SCALAR', values, true);
  }

  /** Takes the values of keys in; the index to name them by. */
  addKeys(type: 'VEC3' | 'VEC4', values: readonly number[]): number {
    return this.add(1, type, values, false);
  }

  /** The properties of the file that say where its numbers are. */
  describe(): { accessors: Accessor[]; bufferViews: object[]; buffers: object[] } {
    let byteOffset = 0;
    const bufferViews = this.views.map(({ numbers, layout }) => {
      const byteLength = 4 * numbers.length;
      const view = { buffer: 0, byteOffset, byteLength, ...layout };
      byteOffset += byteLength;
      return view;
    });
    return { accessors: this.accessors, bufferViews, buffers: [{ byteLength: byteOffset }] };
  }

  bytes(): Uint8Array {
    const all = Float32Array.from(this.views.flatMap(({ numbers }) => numbers));
    return new Uint8Array(all.buffer);
  }

  private add(
    view: number,
    type: AccessorType,
    values: readonly number[],
    ranged: boolean,
  ): number {
    const width = widths[type];
    const { numbers } = this.views[view]!;
    const accessor: Accessor = {
      bufferView: view,
      byteOffset: 4 * numbers.length,
      componentType: float,
      count: values.length / width,
      type,
    };
    // The range is of what is written, which has fewer digits.
    const written = Float32Array.from(values);
    for (const value of written) numbers.push(value);
    if (ranged) {
      const column = (k: number): Float32Array => written.filter((_, i) => i % width === k);
      const columns = Array.from({ length: width }, (_, k) => column(k));
      accessor.min = columns.map((column) => Math.min(...column));
      accessor.max = columns.map((column) => Math.max(...column));
    }
    return this.accessors.push(accessor) - 1;
  }
}

function chunk(type: number, content: Uint8Array, filling: number): Uint8Array {
  const length = Math.ceil(content.length / alignment) * alignment;
  const bytes = new Uint8Array(8 + length).fill(filling);
  const head = new DataView(bytes.buffer);
  head.setUint32(0, length, true);
  head.setUint32(4, type, true);
  bytes.set(content, 8);
  return bytes;
}

/** A binary glTF file from its properties and its numbers. */
export function glbFile(properties: object, numbers: Uint8Array): Uint8Array {
  const text = new TextEncoder().encode(JSON.stringify(properties));
  const chunks = [chunk(jsonChunk, text, space), chunk(binaryChunk, numbers, 0)];
  const head = new Uint32Array([magic, version, 0]);
  const parts = [new Uint8Array(head.buffer), ...chunks];
  head[2] = parts.reduce((sum, { length }) => sum + length, 0);
  const bytes = new Uint8Array(head[2]);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}
