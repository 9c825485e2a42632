/** Reads GLB and glTF files: the triangles of the default scene and how they look, with y up, in metres. */
import { Logger, WebIO, type Document, type GLTF, type Primitive } from '@gltf-transform/core';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import type { LookedFiles } from '../../model/looks.js';
import type { ModelFile } from '../../model/model-files.js';
import type { Message } from '../../model/message.js';
import type { Companions } from '../companions.js';
import { loaded } from '../loading.js';
import { identity, type Affine } from '../matrix.js';
import { Pictures } from '../pictures.js';
import { notice, type ReaderTools } from '../read-model.js';
import { Soup, type Part } from '../soup.js';
import { Unreadable } from '../unreadable.js';
import { Buffers } from './buffers.js';
import { gltfFault, openContainer, type Container } from './container.js';
import { dracoModule, dracoStep, type DracoModule } from './draco.js';
import { geometryExtensions, sortedExtensions } from './extensions.js';
import { geometryJson, type GeometryJson } from './geometry-json.js';
import { GltfLooks } from './gltf-looks.js';
import { Images } from './images.js';
import { partOf, poseOf, type Leftovers, type Pose } from './mesh-parts.js';
import { EndlessScene, placedNodes, type PlacedNode } from './scene.js';
import { gltfNotices } from './unused.js';

const draco = 'KHR_draco_mesh_compression';

/** A file whose numbers are decoded. */
interface Decoded {
  document: Document;
  geometry: GeometryJson;
  buffers: Uint8Array[];
  draco: DracoModule | null;
}

/** Numbers, points and the like in all lists of a file. */
function elementsOf({ accessors = [] }: GLTF.IGLTF): number {
  return accessors.reduce((sum, { count }) => sum + count, 0);
}

async function decode(
  geometry: GeometryJson,
  buffers: Buffers,
  { loadDraco }: ReaderTools,
): Promise<Decoded> {
  const bytes = buffers.all(geometry.buffers);
  const isDraco = geometry.json.extensionsUsed?.includes(draco) ?? false;
  const module = isDraco
    ? await dracoModule(await loaded(loadDraco), elementsOf(geometry.json))
    : null;
  await MeshoptDecoder.ready;
  const io = new WebIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions(geometryExtensions)
    .registerDependencies({ 'draco3d.decoder': module, 'meshopt.decoder': MeshoptDecoder });
  const names = bytes.map((_, i) => `buffer-${i}`);
  const document = await io.readJSON({
    json: {
      ...geometry.json,
      buffers: names.map((uri, i) => ({ uri, byteLength: bytes[i]!.length })),
    },
    resources: Object.fromEntries(
      names.map((name, i) => [name, bytes[i] as Uint8Array<ArrayBuffer>]),
    ),
  });
  return { document, geometry, buffers: bytes, draco: module };
}

/** How coarse Draco has made the positions of a primitive; 0 where it is not at work. */
function stepOf(
  { geometry, buffers, draco: module }: Decoded,
  primitive: GLTF.IMeshPrimitive,
): number {
  const compressed = primitive.extensions?.[draco] as
    { bufferView: number; attributes: Record<string, number> } | undefined;
  const attribute = compressed?.attributes['POSITION'];
  if (!module || !compressed || attribute === undefined) return 0;
  const { buffer, byteOffset = 0, byteLength } = geometry.json.bufferViews![compressed.bufferView]!;
  const bytes = buffers[buffer]!.subarray(byteOffset, byteOffset + byteLength);
  return dracoStep(module, bytes, attribute);
}

/** Gathers what the nodes of a scene show. */
class Scene {
  readonly soup = new Soup();
  readonly leftovers: Leftovers = { points: 0, lines: 0 };
  posed = 0;
  private readonly steps = new Map<GLTF.IMeshPrimitive, number>();
  private readonly places: Map<number, PlacedNode>;

  constructor(
    private readonly json: GLTF.IGLTF,
    private readonly decoded: Decoded,
    private readonly nodes: readonly PlacedNode[],
    private readonly looks: GltfLooks | null,
  ) {
    this.places = new Map(nodes.map((node) => [node.index, node]));
  }

  gather(): void {
    for (const { node, map } of this.nodes) {
      if (node.mesh === undefined) continue;
      const pose = this.poseOf(node);
      this.addMesh(node, pose ? identity : map, pose);
    }
  }

  private addMesh({ mesh: index, weights }: GLTF.INode, map: Affine, pose: Pose | null): void {
    const { document, geometry } = this.decoded;
    const [mesh, definition] = [
      document.getRoot().listMeshes()[index!]!,
      geometry.json.meshes![index!]!,
    ];
    const shares = weights ?? mesh.getWeights();
    mesh.listPrimitives().forEach((primitive, i) => {
      const step = this.step(definition.primitives[i]!);
      const part = partOf(primitive, { weights: shares, pose, step }, this.leftovers);
      if (!part) return;
      const { material } = this.json.meshes![index!]!.primitives[i]!;
      this.soup.add({ ...part, ...this.looksOf(primitive, material, part) }, map);
      if (pose) ++this.posed;
    });
  }

  private looksOf(
    primitive: Primitive,
    material: number | undefined,
    { positions, triangles }: Part,
  ): Pick<Part, 'looks'> {
    const counts = { vertices: positions.length / 3, triangles: triangles.length / 3 };
    return this.looks ? { looks: this.looks.of(primitive, material, counts) } : {};
  }

  private step(primitive: GLTF.IMeshPrimitive): number {
    const known = this.steps.get(primitive);
    const step = known ?? stepOf(this.decoded, primitive);
    this.steps.set(primitive, step);
    return step;
  }

  /** Null for a node without a skin, or one whose joints are not in the scene. */
  private poseOf({ skin }: GLTF.INode): Pose | null {
    const joints = skin === undefined ? undefined : this.json.skins?.[skin]?.joints;
    const places = joints?.map((joint) => this.places.get(joint)?.map);
    if (!places || places.includes(undefined)) return null;
    const accessor = this.decoded.geometry.skinAccessors[skin!] ?? null;
    const unbound =
      accessor === null ? null : this.decoded.document.getRoot().listAccessors()[accessor]!;
    return poseOf(places as Affine[], unbound);
  }
}

function refuseUnknown(file: string, json: GLTF.IGLTF, soup: Soup): void {
  const { unknown } = sortedExtensions(json.extensionsUsed ?? [], json.extensionsRequired ?? []);
  if (soup.triangleCount === 0 && unknown.length > 0) {
    throw gltfFault(file, { what: 'extension', extension: unknown[0]! });
  }
}

/** A file with all that is needed to read it. */
interface Source {
  file: ModelFile;
  container: Container;
  companions: Companions;
  tools: ReaderTools;
}

/** What comes of a glTF file. */
export interface ReadGltf {
  soup: Soup;
  notices: Message[];
  looks: LookedFiles | null;
}

async function read(source: Source, withLooks: boolean): Promise<ReadGltf> {
  const { file, container, companions, tools } = source;
  const { json } = container;
  const nodes = placedNodes(json);
  const buffers = new Buffers(file.name, companions, container);
  const decoded = await decode(geometryJson(json, withLooks), buffers, tools);
  const pictures = new Pictures();
  const looks = withLooks ? new GltfLooks(json, new Images(container, companions, pictures)) : null;
  const scene = new Scene(json, decoded, nodes, looks);
  scene.gather();
  refuseUnknown(file.name, json, scene.soup);
  const notices = gltfNotices(json, { ...scene.leftovers, posed: scene.posed });
  return {
    soup: scene.soup,
    notices: [...notices, ...pictures.notices],
    looks: looks && { materials: looks.materials, pictures: pictures.files },
  };
}

/** A fault of the file's structure, in the libraries or here: numbers that contradict each other. */
function isStructural(error: unknown): boolean {
  return !(error instanceof Unreadable) && !(error instanceof EndlessScene);
}

/** Reads it, and without its looks where these are damaged. */
async function readWhatIsWhole(source: Source): Promise<ReadGltf> {
  try {
    return await read(source, true);
  } catch (error) {
    if (!isStructural(error)) throw error;
    const { notices, ...bare } = await read(source, false);
    return { ...bare, notices: [...notices, notice('damaged-looks', {})] };
  }
}

/** @throws Unreadable for a file that is damaged, lacks others, or holds far too much */
export async function readGltf(
  file: ModelFile,
  isBinary: boolean,
  companions: Companions,
  tools: ReaderTools,
): Promise<ReadGltf> {
  const container = openContainer(file, isBinary);
  try {
    return await readWhatIsWhole({ file, container, companions, tools });
  } catch (error) {
    if (error instanceof EndlessScene) throw gltfFault(file.name, { what: 'cycle' });
    throw isStructural(error) ? gltfFault(file.name, { what: 'structure' }) : error;
  }
}
