/** Sorts faces by how they look, as the graphics card draws them: all of a kind in one go. */
import type { LookedSurface, Material } from '../model/looks.js';

/** Faces of one material, with its picture or without. */
export interface FaceGroup {
  /** Index of the material; -1 for none. */
  material: number;
  hasPicture: boolean;
  /** Corners, 3 per face. */
  corners: number[];
}

/** Faces have the picture of their material only if all their corners have places in it. */
export function faceGroups(
  { places, materials: numbers }: LookedSurface,
  materials: readonly Material[],
  faceCount: number,
): FaceGroup[] {
  const groups = new Map<number, FaceGroup>();
  for (let face = 0; face < faceCount; ++face) {
    const material = materials[numbers?.[face] ?? -1] ? numbers![face]! : -1;
    const isPlaced = places?.subarray(6 * face, 6 * face + 6).every(Number.isFinite) ?? false;
    const hasPicture = isPlaced && (materials[material]?.picture ?? null) !== null;
    const key = 2 * material + Number(hasPicture);
    const group = groups.get(key) ?? { material, hasPicture, corners: [] };
    groups.set(key, group);
    group.corners.push(3 * face, 3 * face + 1, 3 * face + 2);
  }
  return [...groups.values()];
}

/** Writes where the corners of a group lie in its picture, 2 numbers per corner of the surface. */
export function writePlaces(
  uvs: Float32Array,
  places: Float32Array,
  { scale, offset }: Material,
  { corners }: FaceGroup,
): void {
  for (const corner of corners) {
    for (const axis of [0, 1] as const) {
      uvs[2 * corner + axis] = scale[axis] * places[2 * corner + axis]! + offset[axis];
    }
  }
}
