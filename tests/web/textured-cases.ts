/** The shared models that may have colours or pictures. */
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, sep } from 'node:path';
import type { ModelFile } from '../../web/model/model-files.js';

export interface TexturedCase {
  name: string;
  /** Its own file comes first. */
  files: ModelFile[];
  /** To which it is simplified. */
  faces?: number;
  /** Whether faces lie beside the surface that they are compared with. */
  isBeside: boolean;
  /** Whether three.js reads all of it. */
  isReadElsewhere: boolean;
}

const folders = ['textured', 'crafts', 'gltf', 'obj-mtl', '3mf', 'pdo', 'lowpoly'];
const models = /\.(?:obj|glb|gltf|3mf|pdo)$/i;
/** Few faces, of models of more whose colours are to be seen nevertheless. */
const simplified: Readonly<Record<string, number>> = {
  'textured/spot/spot_triangulated.obj': 800,
  'obj-mtl/texture-name-space/fuze.obj': 300,
  'crafts/fox.glb': 300,
};

/** Quads that are not flat, which other programs cut along their other diagonals. */
const bent: readonly string[] = ['textured/spot/spot_control_mesh.obj'];

/** What three.js has no reader for, or reads in part: it leaves out the colour of a whole object where faces have pictures. */
const unread = /\.pdo$|material_multiproperties|production_material_textured_cube/;

function filesBelow(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
}

/** What lies beside a model and is none itself. */
function companionsOf(path: string): string[] {
  const folder = dirname(path);
  return filesBelow(folder).filter((other) => /\.(?:mtl|png|jpe?g|bin)$/i.test(other));
}

function caseOf(root: string, path: string): TexturedCase {
  const name = relative(root, path).split(sep).join('/');
  const folder = dirname(path);
  const isWhole = /\.(?:3mf|pdo)$/i.test(path);
  const all = [path, ...(isWhole ? [] : companionsOf(path))];
  const files = all.map((file) => ({
    name: relative(folder, file).split(sep).join('/'),
    bytes: new Uint8Array(readFileSync(file)),
  }));
  const ownLibrary = files.filter(({ name: file }) => file.toLowerCase().endsWith('.mtl'));
  // A folder of many models has a library for each.
  const text = new TextDecoder('latin1').decode(files[0]!.bytes.subarray(0, 4000));
  const named = ownLibrary.filter((file) => text.includes(file.name.split('/').at(-1)!));
  const others = new Set(
    named.length > 0 ? ownLibrary.filter((file) => !named.includes(file)) : [],
  );
  return {
    name,
    files: files.filter((file) => !others.has(file)),
    isBeside: bent.includes(name),
    isReadElsewhere: !unread.test(name),
  };
}

export function* texturedCases(shared: string): Generator<TexturedCase> {
  const root = join(shared, 'models');
  for (const folder of folders) {
    for (const path of filesBelow(join(root, folder)).filter((file) => models.test(file))) {
      const whole = caseOf(root, path);
      yield whole;
      const faces = simplified[whole.name];
      if (faces) yield { ...whole, name: `${whole.name}, ${faces} faces`, faces, isBeside: true };
    }
  }
}
