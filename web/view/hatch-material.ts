import {
  DataArrayTexture,
  DoubleSide,
  LinearMipmapLinearFilter,
  MeshLambertMaterial,
  RedFormat,
  RepeatWrapping,
} from 'three';
import { hatchInk } from './hatch-tile.js';
import { leaveInsideBlank } from './paper-inside.js';
import { hatchPaths } from './part-hatches.js';

/** Pixels along a tile of a hatch. */
const size = 64;

function hatchTexture(): DataArrayTexture {
  const texture = new DataArrayTexture(hatchInk(size), size, size, hatchPaths.length);
  texture.format = RedFormat;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}

/**
 * Paper, blank on its inside and in the colours of its faces on its outside, with hatches over them
 * when `hatched`. Reads the attributes
 * `uv` (where on the tile) and `hatch` (which one) beside those of every material.
 */
export class HatchMaterial extends MeshLambertMaterial {
  private readonly hatches = hatchTexture();
  private readonly share = { value: 0 };

  constructor() {
    // Pushed back a little, so that lines along the faces lie on top.
    super({
      side: DoubleSide,
      vertexColors: true,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.onBeforeCompile = (shader) => {
      leaveInsideBlank(shader);
      shader.uniforms['hatches'] = { value: this.hatches };
      shader.uniforms['hatchShare'] = this.share;
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', `attribute float hatch;\nvarying vec3 vHatch;\n$&`)
        .replace('#include <color_vertex>', `$&\nvHatch = vec3(uv, hatch);`);
      shader.fragmentShader = shader.fragmentShader
        .replace(
          '#include <common>',
          `uniform sampler2DArray hatches;\nuniform float hatchShare;\nvarying vec3 vHatch;\n$&`,
        )
        .replace(
          '#include <color_fragment>',
          `$&\nfloat ink = hatchShare * texture(hatches, vHatch).r;\n` +
            `diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.02), ink);`,
        );
    };
  }

  set hatched(hatched: boolean) {
    this.share.value = hatched ? 0.75 : 0;
  }

  override dispose(): void {
    this.hatches.dispose();
    super.dispose();
  }
}
