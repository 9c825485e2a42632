/** The JSON of a glTF file, and the buffer that a GLB carries with it (glTF 2.0, section 4.4). */
import type { GLTF } from '@gltf-transform/core';
import type { ModelFile } from '../../model/model-files.js';
import type { GltfFault } from '../../words/messages.js';
import { unreadable } from '../unreadable.js';

export interface Container {
  json: GLTF.IGLTF;
  /** What buffers without an address stand for. */
  binary: Uint8Array | null;
}

const chunkTypes = { json: 0x4e4f534a, binary: 0x004e4942 };
const headerLength = 12;
const chunkHeaderLength = 8;

/** A fault of a glTF file. */
export function gltfFault(file: string, fault: GltfFault): Error {
  return unreadable('bad-gltf', { file, ...fault });
}

function parsed(file: string, bytes: Uint8Array): GLTF.IGLTF {
  let json: unknown;
  try {
    json = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw gltfFault(file, { what: 'json' });
  }
  if (typeof json !== 'object' || json === null) {
    throw gltfFault(file, { what: 'json' });
  }
  return json as GLTF.IGLTF;
}

function chunksOf({ name, bytes }: ModelFile): Container {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const truncated = gltfFault(name, { what: 'truncated' });
  if (bytes.length < headerLength + chunkHeaderLength) throw truncated;
  const version = view.getUint32(4, true);
  if (version !== 2) throw gltfFault(name, { what: 'version', version: String(version) });
  const found = new Map<number, Uint8Array>();
  for (let at = headerLength; at + chunkHeaderLength <= bytes.length;) {
    const [length, type] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    at += chunkHeaderLength;
    if (at + length > bytes.length) throw truncated;
    if (!found.has(type)) found.set(type, bytes.subarray(at, at + length));
    at += length;
  }
  const json = found.get(chunkTypes.json);
  if (!json) throw gltfFault(name, { what: 'json' });
  return { json: parsed(name, json), binary: found.get(chunkTypes.binary) ?? null };
}

/** @throws Unreadable for one that is damaged, or of another version than 2 */
export function openContainer(file: ModelFile, isBinary: boolean): Container {
  const container = isBinary
    ? chunksOf(file)
    : { json: parsed(file.name, file.bytes), binary: null };
  const version = String(container.json.asset?.version ?? '');
  if (!/^2(\.|$)/.test(version)) throw gltfFault(file.name, { what: 'version', version });
  return container;
}
