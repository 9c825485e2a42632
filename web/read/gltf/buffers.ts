/** The bytes that a glTF file refers to: inside it, beside it, or written into its addresses. */
import type { GLTF } from '@gltf-transform/core';
import type { Companions } from '../companions.js';
import { unreadable } from '../unreadable.js';
import { decoded } from '../paths.js';
import { gltfFault, type Container } from './container.js';
import { RangeFault } from './range-fault.js';

const dataAddress = /^data:[^,]*?(;base64)?,/i;

/** Whether an address holds its bytes itself. */
export function isData(address: string): boolean {
  return dataAddress.test(address);
}

/** @throws RangeFault for an address that is none of data */
export function bytesOfData(address: string): Uint8Array {
  const [head, base64] = dataAddress.exec(address) ?? [];
  if (head === undefined) throw new RangeFault();
  const body = decoded(address.slice(head.length));
  const text = base64 === undefined ? body : atob(body);
  return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
}

/** Finds buffers, and remembers those that did not come along. */
export class Buffers {
  private readonly missing: string[] = [];

  constructor(
    private readonly file: string,
    private readonly companions: Companions,
    private readonly container: Container,
  ) {}

  /** The bytes of all these buffers. @throws Unreadable if some are missing or too short */
  all(buffers: readonly GLTF.IBuffer[]): Uint8Array[] {
    const found = buffers.map((buffer) => this.bytesOf(buffer));
    const { file, missing } = this;
    if (missing.length > 0)
      throw unreadable('missing-files', { file, missing: [...new Set(missing)] });
    return found;
  }

  private bytesOf({ uri, byteLength }: GLTF.IBuffer): Uint8Array {
    const bytes = uri === undefined ? this.container.binary : this.named(uri);
    if (!bytes) return new Uint8Array();
    if (bytes.length < byteLength) {
      const detail = uri === undefined || uri.startsWith('data:') ? '' : uri;
      throw gltfFault(this.file, {
        what: 'short-buffer',
        buffer: detail,
        bytes: bytes.length,
        announced: byteLength,
      });
    }
    return bytes;
  }

  private named(uri: string): Uint8Array | null {
    if (isData(uri)) return bytesOfData(uri);
    const found = this.companions.find(uri);
    if (!found) this.missing.push(decoded(uri));
    return found?.bytes ?? null;
  }
}

/** Addresses of the files that a glTF file names: buffers and pictures. */
export function namedFiles({ buffers = [], images = [] }: GLTF.IGLTF): string[] {
  return [...buffers, ...images].flatMap(({ uri }) =>
    uri === undefined || isData(uri) ? [] : [uri],
  );
}
