/** Writes small GLB and glTF files for tests of their reader. */
import { Document, NodeIO, type Accessor, type GLTF, type Node } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import draco from 'draco3dgltf';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import type { Triangles } from './read-model.js';

const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
  'draco3d.encoder': await draco.createEncoderModule(),
  'meshopt.encoder': MeshoptEncoder,
});

/** A document with one scene, whose nodes `add` makes. */
export class Scene {
  readonly document = new Document();
  private readonly scene = this.document.createScene();
  private readonly buffer = this.document.createBuffer();

  /** A node with these triangles; other modes list vertices in their own way. */
  add({ positions, corners }: Triangles, mode = 4, parent: Node | null = null): Node {
    const primitive = this.document
      .createPrimitive()
      .setAttribute('POSITION', this.list('VEC3', new Float32Array(positions)))
      .setIndices(this.list('SCALAR', new Uint16Array(corners)))
      .setMode(mode as 4);
    const mesh = this.document.createMesh().addPrimitive(primitive);
    const node = this.document.createNode().setMesh(mesh);
    if (parent) parent.addChild(node);
    else this.scene.addChild(node);
    return node;
  }

  list(
    type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4',
    values:
      | Float32Array<ArrayBuffer>
      | Uint8Array<ArrayBuffer>
      | Uint16Array<ArrayBuffer>
      | Int16Array<ArrayBuffer>,
  ): Accessor {
    return this.document.createAccessor().setType(type).setArray(values).setBuffer(this.buffer);
  }

  glb(): Promise<Uint8Array> {
    return io.writeBinary(this.document);
  }

  /** The JSON and the buffer beside it, which it calls "data.bin". */
  async separate(): Promise<{ json: GLTF.IGLTF; bin: Uint8Array }> {
    const { json, resources } = await io.writeJSON(this.document, { basename: 'data' });
    return { json, bin: resources['data.bin']! };
  }
}

export function encoded(json: object): Uint8Array {
  return new TextEncoder().encode(JSON.stringify(json));
}
