/** Files of other people's in the formats that are read in TypeScript: what comes of each. */
import { readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join, relative } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { ModelFile } from '../../web/model/model-files.js';
import { sharedFolder } from './command.js';
import { read, refusal, trianglesOf, volumeOf } from './read-model.js';

/** Triangles and volume; or the name of a file that the engine reads; or a part of the sentence that refuses it. */
const table: Readonly<Record<string, readonly [number, number] | string>> = {
  'models/gltf/AnimatedMorphCube/AnimatedMorphCube.gltf': [12, 8],
  'models/gltf/BoxDraco/BoxDraco.gltf': [12, 1],
  'models/gltf/BoxInterleaved.glb': [12, 1],
  'models/gltf/BoxMeshopt.glb': [12, 1],
  'models/gltf/BoxTextured-embedded.gltf': [12, 1],
  'models/gltf/BoxTextured-separate/BoxTextured.gltf': [12, 1],
  'models/gltf/BoxTextured.glb': [12, 1],
  'models/gltf/BoxVertexColors.glb': [12, 1],
  'models/gltf/CesiumMilkTruck.glb': [3624, 19.2],
  'models/gltf/DracoSparseMesh/DracoSparseMesh.gltf': [102, 1.58e-7],
  'models/gltf/SimpleSparseAccessor.gltf': [12, 0],
  'models/gltf/TextureTransformTest/TextureTransformTest.gltf': [24, 0.000367],
  'models/gltf/TwoCubes.glb': [24, 16],
  'models/gltf/box-morph.gltf': [12, 8],
  'models/gltf/box_sparse.glb': [12, -1],
  'models/gltf/gltf_primitives.glb': [12, 8],
  'models/gltf/house-draco-datauri.gltf': [718, 1.05],
  'models/gltf/meshopt-khr-no-fallback/meshopt-no-fallback.gltf': [60, 10],
  'models/gltf/multiple-boxes.gltf': [48, 32],
  'models/gltf/pumpkin-unlit-draco.gltf': [188, 0.0204],
  'models/gltf/simple_skin.gltf': [8, 0],
  'models/gltf/skull-draco.glb': [344, 0.43],
  'models/gltf/skull-jpeg.glb': [344, 0.43],
  'models/gltf/skull-meshopt.glb': [344, 0.43],
  'models/gltf/skull-mirrored-node.glb': [688, 0.859],
  'models/gltf/skull-png.glb': [344, 0.43],
  'models/gltf/skull-quantized.glb': [344, 0.43],
  'models/gltf/triangle-without-indices.gltf': [1, 0],
  'models/3mf/core_box.3mf': [12, 6000],
  'models/3mf/core_components_matrix.3mf': [60, 14000],
  'models/3mf/core_items_matrix.3mf': [60, 14000],
  'models/3mf/core_multiple_cylinders_items_basematerial.3mf': [528, 37200],
  'models/3mf/core_support_object.3mf': [404, 11000],
  'models/3mf/core_torus.3mf': [2200, 777],
  'models/3mf/core_unknown_namespace_bom.3mf': [12, 1000],
  'models/3mf/inch_featuretype.3MF': [2208, 191000],
  'models/3mf/made_bambu_layout_negative_part.3mf': [16, 12000],
  'models/3mf/made_inch_nested_components_mirror.3mf': [32, 393000],
  'models/3mf/made_prusa_layout_modifier_volume.3mf': [16, 12000],
  'models/3mf/made_texture_prefixed_namespace_odd_path.3mf': [16, 12000],
  'models/3mf/made_trianglesets_basematerials.3mf': [16, 12000],
  'models/3mf/material_multiproperties_centimeter.3mf': [12, 1000000],
  'models/3mf/material_pyramid_vertexcolor.3mf': [4, 333],
  'models/3mf/material_rhombicuboctahedron_facecolor.3mf': [44, 1090000],
  'models/3mf/material_sphere_texture.3mf': [3032, 33400],
  'models/3mf/production_box_optional.3mf': [12, 6000],
  'models/3mf/production_components_path.3mf': [8, 188],
  'models/3mf/production_material_textured_cube.3mf': [6, 167000],
  'models/3mf/slicer_bambustudio_project.3mf': [43342, 60500],
  'models/3mf/slicer_sliced_no_geometry.gcode.3mf': 'sliced print job',
  'models/pdo/synthetic_v4.pdo': [16, 12000],
  'models/pdo/synthetic_v5_lock2.pdo': 'is locked by the person who made it',
  'models/pdo/synthetic_v5_no_unfold.pdo': [16, 12000],
  'models/pdo/synthetic_v5_shift200_cp932_ownpage.pdo': [16, 12000],
  'models/pdo/synthetic_v6_flag1.pdo': [16, 12000],
  'models/pdo/synthetic_v6_flag3_designer6_tail.pdo': [16, 12000],
  'models/zip/gltf_folder.zip': [12, 1],
  'models/zip/stl_only.zip': 'little house.STL',
  'models/zip/taxi_macos.zip': 'Taxi Model/car_taxi.obj',
  'models/zip/windows_backslash_utf8_names.zip': 'Auto Tür/car_taxi.obj',
  'models/crafts/boat_224.glb': [224, 16.3],
  'models/crafts/fox.glb': [576, 66500],
  'models/crafts/kenney_house.gltf': [718, 1.05],
  'models/crafts/manta_ray.glb': [696, 10],
  'models/crafts/shark.glb': [644, 47.6],
  'models/crafts/triceratops.glb': [1332, 195],
  'models/crafts/velociraptor.glb': [1248, 13.7],
  'models/crafts/whale.glb': [447, 16.3],
  'nasty/tinygltf/BoundsChecking/integer-out-of-bounds.gltf': [1, 0],
  'nasty/tinygltf/BoundsChecking/invalid-buffer-index.gltf': [0, 0],
  'nasty/tinygltf/BoundsChecking/invalid-buffer-view-index.gltf': 'refer to data that is not there',
  'nasty/tinygltf/BoundsChecking/invalid-primitive-indices.gltf': 'refer to data that is not there',
  'nasty/tinygltf/Cube-texture-ext/Cube-textransform.gltf': [12, 8],
  'nasty/tinygltf/Cube/Cube.gltf': [12, 8],
  'nasty/tinygltf/CubeImageUriSpaces/CubeImageUriMultipleSpaces.gltf': [12, 1],
  'nasty/tinygltf/CubeImageUriSpaces/CubeImageUriSpaces.gltf': [12, 1],
  'nasty/tinygltf/Extensions-issue97/test.gltf': [1, 0],
  'nasty/tinygltf/Extensions-overwrite-issue261/issue-261.gltf': [12, 1],
  'nasty/tinygltf/SparseMorphTargets-issue280/singleBlendshapeCube_sparse.glb': [12, 1e-6],
  'nasty/tinygltf/box01.glb': [12, 1],
  'nasty/tinygltf/regression/unassigned-skeleton.gltf': [8, 0],
  'nasty/tinygltf/regression/zero-sized-bin-chunk-issue-440.glb': [1, 0],
  'nasty/tinygltf/tests/issue-416.gltf': 'glTF of no version',
  'nasty/tinygltf/tests/issue-492.glb': [0, 0],
};

const shared = sharedFolder();

const ofOurs = /\.(glb|gltf|3mf|pdo|zip)$/i;

function filesBelow(folder: string): string[] {
  return readdirSync(join(shared!, folder), { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile() && ofOurs.test(entry.name))
    .map((entry) => relative(shared!, join(entry.parentPath, entry.name)))
    .sort();
}

const fileOf = (path: string): ModelFile => ({
  name: basename(path),
  bytes: new Uint8Array(readFileSync(path)),
});

/** A model with the buffers beside it. */
function filesOf(path: string): ModelFile[] {
  const full = join(shared!, path);
  if (!path.endsWith('.gltf')) return [fileOf(full)];
  const buffers = readdirSync(dirname(full)).filter((name) => name.endsWith('.bin'));
  return [fileOf(full), ...buffers.map((name) => fileOf(join(dirname(full), name)))];
}

async function outcome(path: string): Promise<readonly [number, number] | string> {
  const files = filesOf(path);
  const refused = await refusal(files);
  if (refused !== 'read') return refused;
  const { name, file } = await read(...files);
  if (file.name === name) return name;
  const triangles = trianglesOf(file);
  return [triangles.corners.length / 3, Number(volumeOf(triangles).toPrecision(3))];
}

describe.skipIf(shared === null)('shared files of formats that are read in TypeScript', () => {
  it('are all in the table', () => {
    const folders = [
      'models/gltf',
      'models/3mf',
      'models/pdo',
      'models/zip',
      'models/crafts',
      'nasty',
    ];
    expect(folders.flatMap(filesBelow).sort()).toEqual(Object.keys(table).sort());
  });

  it.each(Object.entries(table))('%s', async (path, expected) => {
    const found = await outcome(path);
    if (typeof expected === 'string') expect(found).toContain(expected);
    else expect(found).toEqual(expected);
  });

  it('are read, all game models', { timeout: 120_000 }, async () => {
    const paths = filesBelow('models/lowpoly');
    expect(paths.length).toBeGreaterThan(50);
    for (const path of paths) {
      const found = await outcome(path);
      expect([path, found]).toEqual([path, [expect.any(Number), expect.any(Number)]]);
      expect(found[0]).toBeGreaterThan(0);
    }
  });
});
