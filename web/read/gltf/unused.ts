/** What a glTF file carries and nothing is made of, each told once. */
import type { GLTF } from '@gltf-transform/core';
import type { Message } from '../../model/message.js';
import { notice } from '../read-model.js';
import { sortedExtensions } from './extensions.js';
import type { Leftovers } from './mesh-parts.js';

function hasAttribute({ meshes = [] }: GLTF.IGLTF, pattern: RegExp): boolean {
  return meshes.some(({ primitives }) =>
    primitives.some(({ attributes }) =>
      Object.keys(attributes ?? {}).some((name) => pattern.test(name)),
    ),
  );
}

function morphTargets({ meshes = [] }: GLTF.IGLTF): number {
  const counts = meshes.map(({ primitives }) =>
    Math.max(0, ...primitives.map(({ targets }) => targets?.length ?? 0)),
  );
  return counts.reduce((sum, count) => sum + count, 0);
}

function instanced({ nodes = [] }: GLTF.IGLTF): number {
  return nodes.filter(({ extensions }) => extensions?.['EXT_mesh_gpu_instancing']).length;
}

function looksOf(json: GLTF.IGLTF): Message[] {
  const hasTextures = (json.textures?.length ?? 0) > 0;
  const hasColours = hasAttribute(json, /^COLOR_/) || (json.materials?.length ?? 0) > 0;
  if (!hasTextures && !hasColours) return [];
  const what = !hasTextures ? 'colours' : !hasColours ? 'textures' : 'both';
  return [notice('materials-ignored', { what })];
}

export function gltfNotices(
  json: GLTF.IGLTF,
  { points, lines, posed }: Leftovers & { posed: number },
): Message[] {
  const notices = looksOf(json);
  if (points + lines > 0) {
    const count = points + lines;
    notices.push(notice('ignored-elements', { count, points, lines, curves: 0, surfaces: 0 }));
  }
  const unused = {
    animations: json.animations?.length ?? 0,
    morphs: morphTargets(json),
    uvs: hasAttribute(json, /^TEXCOORD_[1-9]/) ? 1 : 0,
    cameras: json.cameras?.length ?? 0,
    instances: instanced(json),
  };
  if (posed > 0) notices.push(notice('posed-skins', { count: posed }));
  if (Object.values(unused).some((count) => count > 0))
    notices.push(notice('unused-content', unused));
  const { unknown } = sortedExtensions(json.extensionsUsed ?? [], json.extensionsRequired ?? []);
  if (unknown.length > 0) notices.push(notice('unknown-extensions', { names: unknown }));
  return notices;
}
