/** Reads 3MF packages: what is to be built, in millimetres, with z up. */
import type { Message } from '../../model/message.js';
import type { ModelFile } from '../../model/model-files.js';
import { composed, scaling, type Affine } from '../matrix.js';
import { notice } from '../read-model.js';
import { Soup } from '../soup.js';
import { unreadable } from '../unreadable.js';
import type { Mesh, ModelPart, Placement, ThreeMfObject } from './model-part.js';
import { Package } from './package.js';
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
  readonly leftOut: LeftOut = { supports: 0, modifiers: 0, negatives: 0, unprinted: 0 };
  private readonly settings: SlicerSettings;
  private placements = 0;

  constructor(
    private readonly pack: Package,
    private readonly start: string,
  ) {
    this.settings = pack.settings;
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
    const triangles = this.printed(mesh, id, part);
    if (triangles.length === 0) return;
    this.soup.add({ positions: mesh.positions, triangles, error: mesh.precision.error }, map);
  }

  /** The triangles of a mesh without those of volumes that are not printed. */
  private printed({ triangles }: Mesh, id: string, part: string): number[] {
    const volumes = (this.settings.volumes.get(id) ?? []).filter(({ role }) => role !== 'print');
    // Slicers that note volumes keep all objects in the first part.
    if (volumes.length === 0 || part !== this.start) return triangles;
    volumes.forEach(({ role }) => this.leave(role));
    return triangles.filter((_, i) => {
      const triangle = Math.floor(i / 3);
      return !volumes.some(({ first, last }) => triangle >= first && triangle <= last);
    });
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

function noticesOf(pack: Package, { unknown }: ModelPart, leftOut: LeftOut): Message[] {
  const notices: Message[] = [];
  const { hasColours, hasTextures } = pack.looks;
  if (hasColours || hasTextures) {
    const what = !hasTextures ? 'colours' : !hasColours ? 'textures' : 'both';
    notices.push(notice('materials-ignored', { what }));
  }
  if (Object.values(leftOut).some((count) => count > 0)) {
    notices.push(notice('not-for-printing', { ...leftOut }));
  }
  if (unknown.length > 0) notices.push(notice('unknown-extensions', { names: unknown }));
  return notices;
}

/** @throws Unreadable for a package that is damaged, or has nothing to build */
export function readThreeMf(file: ModelFile): { soup: Soup; notices: Message[] } {
  const pack = new Package(file);
  const start = pack.findStart();
  const first = pack.part(start);
  const build = new Build(pack, start);
  build.run();
  if (build.soup.triangleCount === 0) pack.fail({ what: pack.isSliced ? 'sliced' : 'nothing' });
  return { soup: build.soup, notices: noticesOf(pack, first, build.leftOut) };
}
