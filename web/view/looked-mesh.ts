import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Mesh,
  MeshLambertMaterial,
  SRGBColorSpace,
} from 'three';
import type { Looks, Material } from '../model/looks.js';
import { faceGroups, writePlaces } from './looked-faces.js';
import { flatMesh } from './model-geometry.js';
import { leaveInsideBlank } from './paper-inside.js';
import type { PictureTextures } from './picture-textures.js';

/** Where the corners of the model's faces are drawn, 3 numbers each. */
export interface Corners {
  position: BufferAttribute;
  normal: BufferAttribute;
}

const white = [255, 255, 255] as const;

function shown([red, green, blue]: readonly [number, number, number]): Color {
  return new Color().setRGB(red / 255, green / 255, blue / 255, SRGBColorSpace);
}

/** Colours of corners as the graphics card adds light to them. */
function lightOf(colours: Uint8Array): Float32Array {
  const light = new Float32Array(colours.length);
  for (let at = 0; at < colours.length; at += 3) {
    shown([colours[at]!, colours[at + 1]!, colours[at + 2]!]).toArray(light, at);
  }
  return light;
}

/** Pushed back a little, so that lines along the faces lie on top. */
function paperOf(material: Material | undefined, hasColours: boolean): MeshLambertMaterial {
  const paper = new MeshLambertMaterial({
    color: shown(material?.colour ?? white),
    vertexColors: hasColours,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  paper.onBeforeCompile = leaveInsideBlank;
  return paper;
}

/** Corners of a surface of its own, which stand still. */
function standing({ vertices, faces }: NonNullable<Looks['surface']['original']>): Corners {
  const { positions, normals } = flatMesh(vertices, faces);
  return {
    position: new BufferAttribute(positions, 3),
    normal: new BufferAttribute(normals, 3),
  };
}

/** A model as its files say that it looks. */
export class LookedMesh {
  readonly mesh: Mesh<BufferGeometry, MeshLambertMaterial[]>;

  /**
   * @param corners of the model, which the surface shares with it unless it has an original
   * @param onChange is called when a picture has been decoded
   */
  constructor(
    { surface, materials }: Pick<Looks, 'surface' | 'materials'>,
    pictures: PictureTextures,
    corners: Corners,
    onChange: () => void,
  ) {
    const { position, normal } = surface.original ? standing(surface.original) : corners;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', position);
    geometry.setAttribute('normal', normal);
    if (surface.colours) {
      geometry.setAttribute('color', new BufferAttribute(lightOf(surface.colours), 3));
    }
    const uvs = new Float32Array(2 * position.count);
    const groups = faceGroups(surface, materials, position.count / 3);
    const papers = groups.map((group, i) => {
      const material = materials[group.material];
      const paper = paperOf(material, surface.colours !== null);
      geometry.addGroup(lengthBefore(groups, i), group.corners.length, i);
      if (material && group.hasPicture) {
        writePlaces(uvs, surface.places!, material, group);
        void pictures.of(material).then((texture) => {
          paper.map = texture;
          paper.needsUpdate = true;
          onChange();
        });
      }
      return paper;
    });
    geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
    geometry.setIndex(groups.flatMap(({ corners: list }) => list));
    this.mesh = new Mesh(geometry, papers);
    this.mesh.frustumCulled = false;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    for (const paper of this.mesh.material) paper.dispose();
  }
}

function lengthBefore(groups: readonly { corners: readonly number[] }[], index: number): number {
  return groups.slice(0, index).reduce((sum, { corners }) => sum + corners.length, 0);
}
