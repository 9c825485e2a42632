/** What a glTF file carries and nothing is made of, each told once. */
import type { GLTF } from '@gltf-transform/core';
import type { Message } from '../../model/message.js';
import { notice } from '../read-model.js';
import { baseColourOf } from './base-colour.js';
import { sortedExtensions } from './extensions.js';
import type { Leftovers } from './mesh-parts.js';

/** Whether meshes have sets of texture coordinates beyond the first that no picture is laid by. */
function hasUnusedPlaces(json: GLTF.IGLTF): boolean {
  const primitives = (json.meshes ?? []).flatMap((mesh) => mesh.primitives);
  return primitives.some(({ attributes, material }) => {
    const used = baseColourOf(json, material).picture?.places;
    const sets = Object.keys(attributes ?? {}).filter((name) => /^TEXCOORD_[1-9]/.test(name));
    return sets.some((name) => name !== used);
  });
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

export function gltfNotices(
  json: GLTF.IGLTF,
  { points, lines, posed }: Leftovers & { posed: number },
): Message[] {
  const notices: Message[] = [];
  if (points + lines > 0) {
    const count = points + lines;
    notices.push(notice('ignored-elements', { count, points, lines, curves: 0, surfaces: 0 }));
  }
  const unused = {
    animations: json.animations?.length ?? 0,
    morphs: morphTargets(json),
    uvs: hasUnusedPlaces(json) ? 1 : 0,
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
