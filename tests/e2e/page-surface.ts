/** What three.js reads of a model's files; runs in a page, as pictures need one. */
import {
  ClampToEdgeWrapping,
  Color,
  LoadingManager,
  Matrix3,
  Mesh,
  MeshStandardMaterial,
  MirroredRepeatWrapping,
  RepeatWrapping,
  TextureLoader,
  Vector2,
  Vector3,
  type Material,
  type Object3D,
  type Texture,
  type Wrapping,
} from 'three';
import { ThreeMFLoader } from 'three/examples/jsm/loaders/3MFLoader.js';
import { DRACOLoader } from 'three/examples/jsm/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { MeshoptDecoder } from 'three/examples/jsm/libs/meshopt_decoder.module.js';
import type { Pixels } from '../web/png-pixels.js';
import type { TrueMaterial } from '../web/true-surface.js';

/** A file in base 64, since calls into pages take text. */
export interface SentFile {
  name: string;
  data: string;
}

/** Lists as plain ones, for the same reason; pixels in base 64. */
export type SentSurface = {
  [Key in 'corners' | 'places' | 'colours' | 'materials']: number[];
} & { looks: TrueMaterial[]; pictures: (Omit<Pixels, 'rgba'> & { data: string })[] };

function bytesOf({ data }: SentFile): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
}

/** Resolves as soon as everything that was asked for has come, or has not. */
function allLoaded(manager: LoadingManager): Promise<void> {
  return new Promise((resolve) => {
    manager.onLoad = resolve;
  });
}

/** A loading manager that finds the files themselves, by the last part of their names. */
function managerOf(files: readonly SentFile[]): LoadingManager {
  const manager = new LoadingManager();
  const last = (name: string): string => decodeURI(name).split(/[\\/]/).at(-1)!.toLowerCase();
  const addresses = new Map(
    files.map((file) => [last(file.name), URL.createObjectURL(new Blob([bytesOf(file)]))]),
  );
  manager.setURLModifier((url) =>
    /^(?:data|blob):/.test(url) ? url : (addresses.get(last(url)) ?? url),
  );
  return manager;
}

async function readObj(
  text: string,
  files: readonly SentFile[],
  manager: LoadingManager,
): Promise<Object3D> {
  const loader = new OBJLoader(manager);
  const library = files.find(({ name }) => name.toLowerCase().endsWith('.mtl'));
  if (library) {
    // The loader takes blanks alone, one between words and none at ends of lines.
    const lines = new TextDecoder().decode(bytesOf(library)).replace(/[\t ]+/g, ' ');
    const creator = new MTLLoader(manager).parse(lines.replace(/ *\r?\n/g, '\n'), '');
    manager.itemStart('materials');
    const loaded = allLoaded(manager);
    creator.preload();
    manager.itemEnd('materials');
    await loaded;
    loader.setMaterials(creator);
  }
  const group = loader.parse(text);
  group.traverse((node) => {
    if (node instanceof Mesh) [node.material as Material[]].flat().forEach(leavePictureAlone);
  });
  const pictures = files.filter(({ name }) => /\.(?:png|jpe?g)$/i.test(name));
  if (!library && pictures.length === 1) await layPicture(group, pictures[0]!, manager);
  return group;
}

/** Programs leave `Kd` at grey or black beside a picture, and others do not look at it then, nor are sheets printed so. */
function leavePictureAlone(material: Material): void {
  const { map, color } = material as MeshStandardMaterial;
  if (map) color.set(1, 1, 1);
}

/** Without a library a single picture is what all of the model looks like. */
async function layPicture(
  group: Object3D,
  { name }: SentFile,
  manager: LoadingManager,
): Promise<void> {
  const map = await new TextureLoader(manager).loadAsync(name);
  map.wrapS = map.wrapT = RepeatWrapping;
  group.traverse((node) => {
    if (node instanceof Mesh) node.material = new MeshStandardMaterial({ map });
  });
}

async function read(files: readonly SentFile[]): Promise<Object3D> {
  const manager = managerOf(files);
  const [model] = files;
  const bytes = bytesOf(model!);
  const ending = model!.name.toLowerCase().split('.').at(-1)!;
  if (ending === 'obj') return readObj(new TextDecoder().decode(bytes), files, manager);
  if (ending === '3mf') {
    const loaded = allLoaded(manager);
    manager.itemStart('model');
    const group = new ThreeMFLoader(manager).parse(bytes.buffer);
    manager.itemEnd('model');
    await loaded;
    return group;
  }
  const draco = new DRACOLoader().setDecoderPath('/draco/');
  const loader = new GLTFLoader(manager).setDRACOLoader(draco).setMeshoptDecoder(MeshoptDecoder);
  const { scene } = await loader.parseAsync(bytes.buffer, '');
  draco.dispose();
  return scene;
}

function wrapOf(wrap: Wrapping): TrueMaterial['wrap'][number] {
  if (wrap === ClampToEdgeWrapping) return 'clamp';
  return wrap === MirroredRepeatWrapping ? 'mirror' : 'repeat';
}

function pixelsOf({ image }: Texture<ImageBitmap>): {
  width: number;
  height: number;
  data: string;
} {
  const { width, height } = image;
  const context = new OffscreenCanvas(width, height).getContext('2d')!;
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  let letters = '';
  for (let at = 0; at < data.length; at += 0x8000) {
    letters += String.fromCharCode(...data.subarray(at, at + 0x8000));
  }
  return { width, height, data: btoa(letters) };
}

/** Collects the triangles of meshes, where their nodes, bones and targets put them. */
class Collector {
  readonly surface: SentSurface = {
    corners: [],
    places: [],
    colours: [],
    materials: [],
    looks: [],
    pictures: [],
  };
  private readonly materials = new Map<Material, number>();
  private readonly pictures = new Map<unknown, number>();

  add(mesh: Mesh): void {
    const geometry = mesh.geometry;
    const count = geometry.index?.count ?? geometry.getAttribute('position').count;
    const list = Array.isArray(mesh.material) ? mesh.material : [mesh.material];
    const groups =
      geometry.groups.length > 0 && Array.isArray(mesh.material)
        ? geometry.groups
        : [{ start: 0, count, materialIndex: 0 }];
    const isMirrored = mesh.matrixWorld.determinant() < 0;
    for (const { start, count: size, materialIndex } of groups) {
      const material = list[materialIndex ?? 0] as MeshStandardMaterial;
      for (let at = start; at < Math.min(start + size, count); at += 3) {
        const corners = isMirrored ? [at, at + 2, at + 1] : [at, at + 1, at + 2];
        for (const corner of corners) this.addCorner(mesh, material, corner);
        this.surface.materials.push(this.numberOf(material));
      }
    }
  }

  private addCorner(mesh: Mesh, material: MeshStandardMaterial, corner: number): void {
    const geometry = mesh.geometry;
    const vertex = geometry.index ? geometry.index.getX(corner) : corner;
    const place = mesh.getVertexPosition(vertex, new Vector3()).applyMatrix4(mesh.matrixWorld);
    this.surface.corners.push(...place.toArray());
    const colours = geometry.getAttribute('color');
    const colour = new Color(1, 1, 1);
    if (material.vertexColors && colours) colour.fromBufferAttribute(colours, vertex);
    this.surface.colours.push(...colour.toArray());
    const { map } = material;
    const uvs = map && geometry.getAttribute(map.channel === 0 ? 'uv' : `uv${map.channel}`);
    if (!map || !uvs) {
      this.surface.places.push(NaN, NaN);
      return;
    }
    if (map.matrixAutoUpdate) map.updateMatrix();
    const uv = new Vector2(uvs.getX(vertex), uvs.getY(vertex)).applyMatrix3(
      new Matrix3().copy(map.matrix),
    );
    this.surface.places.push(uv.x, map.flipY ? 1 - uv.y : uv.y);
  }

  private numberOf(material: MeshStandardMaterial): number {
    const known = this.materials.get(material);
    if (known !== undefined) return known;
    const { color, map } = material;
    const number = this.surface.looks.length;
    this.materials.set(material, number);
    this.surface.looks.push({
      colour: [color.r, color.g, color.b],
      picture: map?.image ? this.pictureOf(map as Texture<ImageBitmap>) : null,
      wrap: map ? [wrapOf(map.wrapS), wrapOf(map.wrapT)] : ['clamp', 'clamp'],
    });
    return number;
  }

  private pictureOf(map: Texture<ImageBitmap>): number {
    const known = this.pictures.get(map.image);
    if (known !== undefined) return known;
    const number = this.surface.pictures.length;
    this.pictures.set(map.image, number);
    this.surface.pictures.push(pixelsOf(map));
    return number;
  }
}

/** The surface of a model, whose own file comes first. */
export async function pageSurface(files: readonly SentFile[]): Promise<SentSurface> {
  const scene = await read(files);
  scene.updateMatrixWorld(true);
  const collector = new Collector();
  scene.traverse((node) => {
    if (node instanceof Mesh) collector.add(node as Mesh);
  });
  return collector.surface;
}

declare global {
  interface Window {
    pageSurface: typeof pageSurface;
  }
}

window.pageSurface = pageSurface;
