/** The colour and the picture that a glTF material gives a surface before any light falls on it. */
import type { GLTF } from '@gltf-transform/core';
import { ofLight, white, type Colour } from '../colours.js';

/** How places are moved before a picture is looked up (KHR_texture_transform). */
export interface PlaceTransform {
  offset: readonly [number, number];
  /** Radians, counter-clockwise. */
  rotation: number;
  scale: readonly [number, number];
}

export interface BaseColour {
  colour: Colour;
  /** Null for a plain one. */
  picture: {
    /** Index of the texture. */
    texture: number;
    /** Name of the attribute with the places. */
    places: string;
    transform: PlaceTransform;
  } | null;
}

type Transform = Partial<PlaceTransform> & { texCoord?: number };

/** Materials from before there was one model for all (KHR_materials_pbrSpecularGlossiness). */
interface OldMaterial {
  diffuseFactor?: number[];
  diffuseTexture?: GLTF.ITextureInfo;
}

function pictureOf({ index, texCoord, extensions }: GLTF.ITextureInfo): BaseColour['picture'] {
  const moved = extensions?.['KHR_texture_transform'] as Transform | undefined;
  const { offset = [0, 0], rotation = 0, scale = [1, 1] } = moved ?? {};
  const places = `TEXCOORD_${moved?.texCoord ?? texCoord ?? 0}`;
  return { texture: index, places, transform: { offset, rotation, scale } };
}

/** @param index of the material; undefined for what has none */
export function baseColourOf({ materials }: GLTF.IGLTF, index: number | undefined): BaseColour {
  const material = index === undefined ? undefined : materials?.[index];
  const old = material?.extensions?.['KHR_materials_pbrSpecularGlossiness'] as
    OldMaterial | undefined;
  const base = material?.pbrMetallicRoughness;
  const factor = base?.baseColorFactor ?? old?.diffuseFactor;
  const texture = base?.baseColorTexture ?? old?.diffuseTexture;
  return {
    colour: factor ? ofLight(factor) : white,
    picture: texture ? pictureOf(texture) : null,
  };
}
