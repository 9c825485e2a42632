import type { Material } from '../../model/looks.js';
import type { ModelFile } from '../../model/model-files.js';
import type { Colour } from '../colours.js';
import { decoded } from '../paths.js';
import type { Pictures } from '../pictures.js';
import type { Properties, PropertyGroup, Texture } from './properties.js';

/** How a corner looks. */
export interface CornerLook {
  /** Tells it apart from others that have a place or a colour; 0 for those that have neither. */
  key: number;
  /** Number of the material, -1 for none. */
  material: number;
  place: readonly [number, number] | null;
  colour: Colour | null;
}

export const bare: CornerLook = { key: 0, material: -1, place: null, colour: null };

/** A property of a group that is not made of others. */
interface Simple {
  group: PropertyGroup;
  id: number;
  index: number;
}

/**
 * The materials of a package, and how corners look by the properties of its parts. Of layers the topmost picture is
 * taken, or else the topmost colour; of mixtures the material that they have most of.
 */
export class PackageLooks {
  readonly materials: Material[] = [];
  /** Whether something lies over something else, or is mixed, and only one of that is shown. */
  isSimplified = false;
  /** Properties that are referred to, but are not there. */
  lost = 0;
  private readonly numbers = new Map<string, number>();
  private readonly known = new Map<string, CornerLook>();

  constructor(
    private readonly pictures: Pictures,
    private readonly find: (path: string) => ModelFile | null,
  ) {}

  /** @param part path of the part that has the properties */
  of(part: string, properties: Properties, group: number, index: number): CornerLook {
    if (group === -1 || index === -1) return bare;
    const key = `${part}\n${group}\n${index}`;
    const known = this.known.get(key);
    if (known) return known;
    const simple = this.simple(properties, group, index);
    const look = simple && this.lookOf(part, properties, simple);
    if (!look) ++this.lost;
    this.known.set(key, look ?? bare);
    return look ?? bare;
  }

  private simple({ groups }: Properties, id: number, index: number): Simple | null {
    const group = groups.get(id);
    if (group?.kind !== 'layers') return this.unmixed(groups, id, index);
    const layers = group.groups.flatMap(
      (inner, i) => this.unmixed(groups, inner, group.rows[index]?.[i] ?? 0) ?? [],
    );
    this.isSimplified ||= layers.length > 1;
    const pictures = layers.filter((layer) => layer.group.kind === 'picture');
    return pictures.at(-1) ?? layers.at(-1) ?? null;
  }

  private unmixed(groups: Properties['groups'], id: number, index: number): Simple | null {
    const group = groups.get(id);
    if (!group || group.kind === 'layers') return null;
    if (group.kind !== 'mixtures') return { group, id, index };
    const [inner, chosen] = [groups.get(group.materials), group.chosen[index]];
    if (inner?.kind !== 'materials' || chosen === undefined) return null;
    this.isSimplified = true;
    return { group: inner, id: group.materials, index: chosen };
  }

  private lookOf(
    part: string,
    { textures }: Properties,
    { group, id, index }: Simple,
  ): CornerLook | null {
    const key = this.known.size + 1;
    if (group.kind === 'colours') {
      const colour = group.colours[index];
      return colour ? { ...bare, key, colour } : null;
    }
    if (group.kind === 'picture') {
      const [right, up] = [group.places[2 * index], group.places[2 * index + 1]];
      const texture = textures.get(group.texture);
      if (right === undefined || up === undefined || !texture) return null;
      const material = this.numberOf(`${part}\npicture\n${group.texture}`, () =>
        this.withPicture(texture),
      );
      return { ...bare, key, material, place: [right, up] };
    }
    const base = group.kind === 'materials' ? group.materials[index] : undefined;
    if (!base) return null;
    return {
      ...bare,
      material: this.numberOf(`${part}\n${id}\n${index}`, () => plainMaterial(base)),
    };
  }

  private numberOf(key: string, make: () => Material): number {
    const known = this.numbers.get(key);
    if (known !== undefined) return known;
    const number = this.materials.push(make()) - 1;
    this.numbers.set(key, number);
    return number;
  }

  private withPicture({ path, wrap }: Texture): Material {
    const name = decoded(path).replace(/^\/+/, '');
    const picture = this.pictures.add(path, name, () => this.find(path));
    return { ...plainMaterial({ name, colour: [255, 255, 255] }), picture, wrap };
  }
}

function plainMaterial({ name, colour }: Pick<Material, 'name' | 'colour'>): Material {
  return { name, colour, picture: null, wrap: ['repeat', 'repeat'], scale: [1, 1], offset: [0, 0] };
}
