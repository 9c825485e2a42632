/** The decoder of Draco meshes, and how coarse it says that their positions are. */
import createDecoder from 'draco3dgltf/draco_decoder_gltf_nodejs.js';

interface Status {
  ok(): boolean;
}

interface QuantizationTransform {
  InitFromAttribute(attribute: object): boolean;
  quantization_bits(): number;
  range(): number;
}

interface Decoder {
  SkipAttributeTransform(type: number): void;
  DecodeBufferToMesh(buffer: object, mesh: object): Status;
  GetAttributeByUniqueId(mesh: object, id: number): object;
}

/** What is used of the decoder's module. */
export interface DracoModule {
  POSITION: number;
  Decoder: new () => Decoder;
  DecoderBuffer: new () => { Init(bytes: Int8Array, length: number): void };
  Mesh: new () => object;
  AttributeQuantizationTransform: new () => QuantizationTransform;
  destroy(object: object): void;
}

/** Bytes that the decoder has to begin with, and some to spare. */
const baseMemory = 24 * 2 ** 20;

/** Bytes that decoding takes per corner and vertex, at most: tables, and attributes before and after. */
const memoryPerElement = 512;

const pageSize = 65_536;

/** Keeps a memory from growing beyond a limit: whoever asks for more is refused. */
function limit(memory: WebAssembly.Memory, most: number): void {
  const grow = memory.grow.bind(memory);
  memory.grow = (pages) => {
    if (memory.buffer.byteLength + pageSize * pages > most) throw new RangeError();
    return grow(pages);
  };
}

/**
 * A decoder for meshes of so many corners and vertices. Damaged data that would make it read tables of any length,
 * for minutes, meets the end of its memory within seconds, which throws.
 */
export async function dracoModule(wasm: Uint8Array, elements: number): Promise<DracoModule> {
  const module = await WebAssembly.compile(wasm as Uint8Array<ArrayBuffer>);
  const made = await createDecoder({
    instantiateWasm(imports, done) {
      const instance = new WebAssembly.Instance(module, imports);
      for (const part of Object.values(instance.exports)) {
        if (part instanceof WebAssembly.Memory)
          limit(part, baseMemory + memoryPerElement * elements);
      }
      done(instance);
      return instance.exports;
    },
    // What it says of damaged data is told in other words.
    printErr: () => undefined,
  });
  return made as DracoModule;
}

/**
 * The distance between neighbouring values that positions can have; 0 where they were not rounded.
 *
 * @param attribute number of the positions in the compressed mesh
 */
export function dracoStep(module: DracoModule, bytes: Uint8Array, attribute: number): number {
  const [decoder, buffer, mesh, transform] = [
    new module.Decoder(),
    new module.DecoderBuffer(),
    new module.Mesh(),
    new module.AttributeQuantizationTransform(),
  ];
  try {
    buffer.Init(new Int8Array(bytes.buffer, bytes.byteOffset, bytes.length), bytes.length);
    decoder.SkipAttributeTransform(module.POSITION);
    if (!decoder.DecodeBufferToMesh(buffer, mesh).ok()) return 0;
    const positions = decoder.GetAttributeByUniqueId(mesh, attribute);
    if (!transform.InitFromAttribute(positions)) return 0;
    return transform.range() / (2 ** transform.quantization_bits() - 1);
  } finally {
    for (const each of [decoder, buffer, mesh, transform]) module.destroy(each);
  }
}
