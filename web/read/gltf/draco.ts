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

export async function dracoModule(wasm: Uint8Array): Promise<DracoModule> {
  return (await createDecoder({ wasmBinary: wasm })) as DracoModule;
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
