/** How models of other people's look, from their files to the result, as the command line reads them. */
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { Session } from '../../web/api/session.js';
import { readModelFiles } from '../../web/cli/read-model-files.js';
import type { Pool } from '../../web/core/pool.js';
import type { JobResult } from '../../web/model/job.js';
import type { LookedSurface } from '../../web/model/looks.js';
import { sharedFolder } from './command.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

/** Materials, pictures, the share of faces with places in them, whether there are colours, and notices of looks. */
type Row = readonly [number, number, number, boolean, readonly string[]];

const oneWithPicture: Row = [1, 1, 1, false, []];

/** Null: the files say nothing of looks, or nothing but white. */
const table: Readonly<Record<string, Row | null>> = {
  'obj-mtl/material-name-spaces/box_mat_with_spaces.obj': [1, 0, 0, false, []],
  'obj-mtl/mtl-in-subfolder/mtl_different_folder.obj': [1, 0, 0, false, ['missing-looks']],
  'obj-mtl/spider-backslash/spider.obj': [4, 4, 1, false, []],
  'obj-mtl/taxi-variants/absolute-windows-path/car_taxi.obj': oneWithPicture,
  'obj-mtl/taxi-variants/backslash-subfolder/car_taxi.obj': oneWithPicture,
  'obj-mtl/taxi-variants/case-crlf-doubled-backslash/car_taxi.obj': oneWithPicture,
  'obj-mtl/taxi-variants/map-options/car_taxi.obj': oneWithPicture,
  'obj-mtl/taxi-variants/original/car_taxi.obj': oneWithPicture,
  'obj-mtl/taxi-variants/spaces-everywhere/car taxi.obj': oneWithPicture,
  'obj-mtl/texture-name-space/fuze.obj': oneWithPicture,
  'gltf/BoxInterleaved.glb': [1, 0, 0, false, []],
  'gltf/BoxTextured-embedded.gltf': oneWithPicture,
  'gltf/BoxTextured-separate/BoxTextured.gltf': oneWithPicture,
  'gltf/BoxTextured.glb': oneWithPicture,
  'gltf/BoxVertexColors.glb': [1, 0, 0, true, []],
  'gltf/CesiumMilkTruck.glb': [4, 1, 0.9, false, []],
  'gltf/SimpleSparseAccessor.gltf': null,
  'gltf/TextureTransformTest/TextureTransformTest.gltf': [9, 5, 1, false, []],
  'gltf/TwoCubes.glb': [2, 0, 0, false, []],
  'gltf/gltf_primitives.glb': [4, 0, 0, false, []],
  'gltf/pumpkin-unlit-draco.gltf': [2, 0, 0, false, []],
  'gltf/skull-draco.glb': oneWithPicture,
  'gltf/skull-jpeg.glb': oneWithPicture,
  'gltf/skull-meshopt.glb': oneWithPicture,
  'gltf/skull-mirrored-node.glb': oneWithPicture,
  'gltf/skull-png.glb': oneWithPicture,
  'gltf/skull-quantized.glb': oneWithPicture,
  '3mf/core_box.3mf': null,
  '3mf/core_multiple_cylinders_items_basematerial.3mf': [1, 0, 0, false, []],
  '3mf/made_texture_prefixed_namespace_odd_path.3mf': [1, 1, 0.9, false, []],
  '3mf/made_trianglesets_basematerials.3mf': [2, 0, 0, false, []],
  '3mf/material_multiproperties_centimeter.3mf': [1, 1, 0.2, true, ['simplified-looks']],
  '3mf/material_pyramid_vertexcolor.3mf': [0, 0, 0, true, []],
  '3mf/material_rhombicuboctahedron_facecolor.3mf': [0, 0, 0, true, []],
  '3mf/material_sphere_texture.3mf': [1, 1, 0.2, true, []],
  'crafts/boat_224.glb': [2, 0, 0, false, []],
  'crafts/fox.glb': oneWithPicture,
  'crafts/kaykit_bridge/building_bridge_A.obj': oneWithPicture,
  'crafts/kaykit_skull/skull.obj': oneWithPicture,
  'crafts/whale.glb': [2, 0, 0, false, []],
  'crafts/wolf_1000.obj': null,
  'lowpoly/kaykit-dungeon/gltf/stool.gltf.glb': oneWithPicture,
  'lowpoly/kaykit-dungeon/obj/stool.obj': oneWithPicture,
  'lowpoly/kenney/Starter-Kit-3D-Platformer/models/grass.glb': oneWithPicture,
  'lowpoly/kenney/Starter-Kit-Racing/models/track-straight.glb': oneWithPicture,
};

const shared = sharedFolder();
const none = (): Promise<Uint8Array> => Promise.reject(new Error('not needed here'));

/** Few faces, so that it takes no time; looks are those of the surface before. */
const options = { runs: 4, seed: 1, folding: 'off', faces: 100 } as const;

async function resultOf(pool: Pool, path: string): Promise<JobResult> {
  const files = readModelFiles(join(shared!, 'models', path));
  const session = new Session(files, { pool: () => pool, loadFont: none, loadRenderer: none });
  await session.run(options);
  return session.result();
}

/** Share of the faces that have places in pictures at all corners. */
function placedShare({ places }: LookedSurface): number {
  if (!places) return 0;
  const faces = places.length / 6;
  const placed = Array.from({ length: faces }, (_, face) =>
    places.subarray(6 * face, 6 * face + 6).every(Number.isFinite),
  );
  return Number((placed.filter(Boolean).length / faces).toFixed(1));
}

const aboutLooks = /looks|pictures?|libraries|materials|files-ignored/;

function rowOf({ looks, notices }: JobResult): Row | null {
  if (!looks) return null;
  const { surface, materials, pictures } = looks;
  const codes = notices.map(({ code }) => code).filter((code) => aboutLooks.test(code));
  const share = placedShare(surface);
  return [materials.length, pictures.length, share, surface.colours !== null, codes];
}

/** Lists of a surface are as long as it has faces, and numbers are those of materials. */
function expectWhole({ model, looks }: JobResult): void {
  if (!looks) return;
  const { surface, materials } = looks;
  const faces = (surface.original?.faces ?? model.faces).length / 3;
  const lengths = [surface.places, surface.colours, surface.materials].map((list) => list?.length);
  expect([6 * faces, undefined]).toContain(lengths[0]);
  expect([9 * faces, undefined]).toContain(lengths[1]);
  expect([faces, undefined]).toContain(lengths[2]);
  for (const number of new Set(surface.materials)) {
    expect(number).toBeGreaterThanOrEqual(-1);
    expect(number).toBeLessThan(materials.length);
  }
}

describe.skipIf(shared === null || !isEngineBuilt)('looks of shared models', () => {
  it('come with the results', { timeout: 240_000 }, () =>
    withThreads(1, async (pool) => {
      for (const [path, expected] of Object.entries(table)) {
        const result = await resultOf(pool, path);
        expect([path, rowOf(result)]).toEqual([path, expected]);
        expectWhole(result);
      }
    }),
  );

  it('say which pictures are missing, and keep colours until they come', () =>
    withThreads(1, async (pool) => {
      const result = await resultOf(pool, 'obj-mtl/taxi-variants/missing-image/car_taxi.obj');
      const params = { what: 'pictures', files: ['not_here.png'] };
      expect(result.notices).toContainEqual({ code: 'missing-looks', params });
    }));

  it('are all sets of OBJ with MTL files', () => {
    const all = readdirSync(join(shared!, 'models/obj-mtl'), { recursive: true }) as string[];
    const models = all.filter((name) => name.endsWith('.obj')).map((name) => `obj-mtl/${name}`);
    const known = Object.keys(table).filter((path) => path.startsWith('obj-mtl'));
    const missing = 'obj-mtl/taxi-variants/missing-image/car_taxi.obj';
    expect(models.sort()).toEqual([...known, missing].sort());
  });
});
