/** Reads 3MF packages: what is to be built and how it looks, in millimetres, with z up. */
import type { Message } from '../../model/message.js';
import type { LookedFiles } from '../../model/looks.js';
import type { ModelFile } from '../../model/model-files.js';
import { composed, scaling, type Affine } from '../matrix.js';
import { Pictures } from '../pictures.js';
import { notice } from '../read-model.js';
import { Soup } from '../soup.js';
import { unreadable } from '../unreadable.js';
import { lookedMesh } from './looked-mesh.js';
import type { Mesh, ModelPart, Placement, ThreeMfObject } from './model-part.js';
import { Package } from './package.js';
import { PackageLooks } from './package-looks.js';
import type { Role, SlicerSettings } from './slicer-settings.js';

/** Far more than anyone prints; objects that hold each other many times over would be endless. */
const mostPlacements = 200_000;

/** Object types that are not part of what is made (3MF core 1.3, section 4.1.1). */
const helpers = ['support', 'solidsupport', 'other'];

/** What a slicer or the file says not to make, by kind. */
interface LeftOut {
  supports: number;
  modifiers: number;
  negatives: number;
  unprinted: number;
}

/** Where an object is, and what it is part of. */
interface Place {
  part: string;
  map: Affine;
  depth: number;
  /** The object on the bed that it belongs to. */
  root: string;
  role: Role;
}

/** Gathers what is built. */
class Build {
  readonly soup = new Soup();
  readonly pictures = new Pictures();
  readonly looks: PackageLooks;
  readonly leftOut: LeftOut = { supports: 0, modifiers: 0, negatives: 0, unprinted: 0 };
  private readonly settings: SlicerSettings;
  private placements = 0;

  constructor(
    private readonly pack: Package,
    private readonly start: string,
  ) {
    this.settings = pack.settings;
    this.looks = new PackageLooks(this.pictures, (path) => pack.picture(path));
  }

  run(): void {
    const { start } = this;
    const { items, objects, unit } = this.pack.part(start);
    for (const item of items.length > 0 ? items : allOf(objects)) {
      if (item.isOff) ++this.leftOut.unprinted;
      else
        this.place(item, {
          part: start,
          map: scaling(unit),
          depth: 0,
          root: item.object,
          role: 'print',
        });
    }
  }

  private place(placement: Placement, outer: Place): void {
    const part = placement.path ?? outer.part;
    const object = this.pack.part(part).objects.get(placement.object);
    const { object: id } = placement;
    if (!object) return this.pack.fail({ what: 'no-object', object: id, part });
    // No chain of different objects is that long.
    if (++this.placements > mostPlacements || outer.depth > 1000)
      this.pack.fail({ what: 'cycle', object: id });
    if (outer.role !== 'print') return this.leave(outer.role);
    if (helpers.includes(object.type)) return void ++this.leftOut.supports;
    const place = {
      ...outer,
      part,
      map: composed(outer.map, placement.map),
      depth: outer.depth + 1,
    };
    this.addMesh(object.mesh, id, place);
    for (const component of object.components) {
      const role = this.settings.components.get(place.root)?.get(component.object) ?? 'print';
      this.place(component, { ...place, role });
    }
  }

  private leave(role: Role): void {
    if (role === 'negative') ++this.leftOut.negatives;
    else ++this.leftOut.modifiers;
  }

  private addMesh(mesh: Mesh, id: string, { map, part }: Place): void {
    const vertices = mesh.positions.length / 3;
    mesh.triangles.forEach((index, i) => {
      if (index < vertices) return;
      const at = Math.floor(i / 3);
      throw unreadable('bad-index', {
        what: 'beyond',
        first: 0,
        index,
        vertices,
        place: 'triangle',
        at,
      });
    });
    const printed = this.printed(mesh, id, part);
    if (printed.length === 0) return;
    const { properties } = this.pack.part(part);
    const shape = lookedMesh(mesh, printed, mesh.properties, (group, index) =>
      this.looks.of(part, properties, group, index),
    );
    this.soup.add({ ...shape, error: mesh.precision.error }, map);
  }

  /** Numbers of the triangles of a mesh, without those of volumes that are not printed. */
  private printed({ triangles }: Mesh, id: string, part: string): number[] {
    const all = Array.from({ length: triangles.length / 3 }, (_, triangle) => triangle);
    const volumes = (this.settings.volumes.get(id) ?? []).filter(({ role }) => role !== 'print');
    // Slicers that note volumes keep all objects in the first part.
    if (volumes.length === 0 || part !== this.start) return all;
    volumes.forEach(({ role }) => this.leave(role));
    return all.filter(
      (triangle) => !volumes.some(({ first, last }) => triangle >= first && triangle <= last),
    );
  }
}

/** Objects that no other one is made of, for files that do not say what is built. */
function allOf(objects: ReadonlyMap<string, ThreeMfObject>): Placement[] {
  const held = new Set(
    [...objects.values()].flatMap(({ components }) => components.map(({ object }) => object)),
  );
  const roots = [...objects.keys()].filter((id) => !held.has(id));
  return roots.map((object) => ({ object, path: null, map: scaling(1), isOff: false }));
}

function noticesOf({ unknown }: ModelPart, { leftOut, looks, pictures }: Build): Message[] {
  const notices: Message[] = [];
  if (Object.values(leftOut).some((count) => count > 0)) {
    notices.push(notice('not-for-printing', { ...leftOut }));
  }
  if (unknown.length > 0) notices.push(notice('unknown-extensions', { names: unknown }));
  if (looks.isSimplified) notices.push(notice('simplified-looks', {}));
  if (looks.lost > 0) notices.push(notice('lost-looks', { count: looks.lost }));
  return [...notices, ...pictures.notices];
}

/** @throws Unreadable for a package that is damaged, or has nothing to build */
export function readThreeMf(file: ModelFile): {
  soup: Soup;
  notices: Message[];
  looks: LookedFiles;
} {
  const pack = new Package(file);
  const start = pack.findStart();
  const first = pack.part(start);
  const build = new Build(pack, start);
  build.run();
  if (build.soup.triangleCount === 0) pack.fail({ what: pack.isSliced ? 'sliced' : 'nothing' });
  const looks = { materials: build.looks.materials, pictures: build.pictures.files };
  return { soup: build.soup, notices: noticesOf(first, build), looks };
}
