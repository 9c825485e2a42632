/** Which extensions of glTF concern geometry, and which can be left alone. */
import type { Extension } from '@gltf-transform/core';
import {
  EXTMeshoptCompression,
  KHRAccessorFloat16,
  KHRAccessorFloat64,
  KHRDracoMeshCompression,
  KHRMeshQuantization,
} from '@gltf-transform/extensions';

/** Those that decide what positions are. */
export const geometryExtensions: (typeof Extension)[] = [
  EXTMeshoptCompression,
  KHRAccessorFloat16,
  KHRAccessorFloat64,
  KHRDracoMeshCompression,
  KHRMeshQuantization,
];

/** The later name of the same compression; its fields are alike. */
const otherNames: Readonly<Record<string, string>> = {
  KHR_meshopt_compression: EXTMeshoptCompression.EXTENSION_NAME,
};

/** Extensions of looks, lights, names and the like: without them the shape is the same. */
const harmless =
  /^(?:KHR_(?:materials|texture|lights|xmp|animation|audio|physics)_?|EXT_(?:texture|lights|structural_metadata|mesh_features)_?|(?:MSFT|ADOBE|AGI|NV|GODOT|VRM|VRMC|FB|GRIFFEL|CESIUM)_)/;

const known = geometryExtensions.map(({ EXTENSION_NAME }) => EXTENSION_NAME);

export interface SortedExtensions {
  /** Those that the file uses and that are read. */
  read: string[];
  /** Those that it must not be read without, and that nobody here knows. */
  unknown: string[];
}

export function sortedExtensions(
  used: readonly string[],
  required: readonly string[],
): SortedExtensions {
  const names = [...new Set([...used, ...required])].map((name) => otherNames[name] ?? name);
  return {
    read: names.filter((name) => known.includes(name)),
    unknown: required.filter(
      (name) => !known.includes(otherNames[name] ?? name) && !harmless.test(name),
    ),
  };
}

/** A value in which extensions have the names under which they are read. */
export function withKnownNames<Value>(value: Value): Value {
  if (Array.isArray(value)) return value.map(withKnownNames) as Value;
  if (typeof value !== 'object' || value === null) return value;
  const entries = Object.entries(value).map(([name, part]) => [
    otherNames[name] ?? name,
    withKnownNames(part as unknown),
  ]);
  return Object.fromEntries(entries) as Value;
}
