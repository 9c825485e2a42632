import type { GLTF } from '@gltf-transform/core';
import type { ModelFile } from '../model/model-files.js';
import { formatOf } from './format.js';
import { neededFiles as neededByGltf } from './gltf/buffers.js';
import { decoded, normalized } from './paths.js';

/** Paths, relative to a model's file, of those that it cannot be read without; none that leads out of its folder. */
export function neededFiles({ bytes }: Pick<ModelFile, 'bytes'>): string[] {
  if (formatOf(bytes) !== 'gltf') return [];
  try {
    const json = JSON.parse(new TextDecoder().decode(bytes)) as GLTF.IGLTF;
    const paths = neededByGltf(json).flatMap((address) => normalized(decoded(address)) ?? []);
    return [...new Set(paths)];
  } catch {
    // Whoever reads it says why it is unreadable.
    return [];
  }
}
