/** Colours, materials and places in pictures that triangles of a 3MF part may refer to (3MF materials 1.2). */
import type { Wrap } from '../../model/looks.js';
import { white, type Colour } from '../colours.js';
import type { Element } from './xml.js';

/** Properties by their numbers in a group. */
export type PropertyGroup =
  | { kind: 'colours'; colours: Colour[] }
  | { kind: 'materials'; materials: { name: string; colour: Colour }[] }
  /** 2 per property, to the right and up. */
  | { kind: 'picture'; texture: number; places: number[] }
  /** The number of the material that each mixture has most of. */
  | { kind: 'mixtures'; materials: number; chosen: number[] }
  /** Per property, one of each group: the last ones lie on top. */
  | { kind: 'layers'; groups: number[]; rows: number[][] };

export interface Texture {
  /** In the package. */
  path: string;
  wrap: readonly [Wrap, Wrap];
}

export interface Properties {
  /** By their numbers in the part. */
  groups: Map<number, PropertyGroup>;
  textures: Map<number, Texture>;
}

/** A number that a word stands for. @throws where it is none */
export type ReadNumber = (word: string) => number;

/** "#RRGGBB", or with two more for how opaque it is. */
function colourOf(word = ''): Colour {
  const [, red, green, blue] = /^\s*#?(..)(..)(..)/.exec(word) ?? [];
  if (red === undefined) return white;
  const [r = NaN, g = NaN, b = NaN] = [red, green, blue].map((part) => parseInt(part!, 16));
  return Number.isNaN(r + g + b) ? white : [r, g, b];
}

const tileStyles: Readonly<Record<string, Wrap>> = {
  mirror: 'mirror',
  clamp: 'clamp',
  none: 'clamp',
};

function indexOfLargest(values: readonly number[]): number {
  return values.indexOf(Math.max(...values));
}

/** Takes in the elements of a part that are about looks. */
export class PropertyListener {
  readonly properties: Properties = { groups: new Map(), textures: new Map() };
  private group: PropertyGroup | null = null;
  /** Of the materials that are mixed. */
  private mixed: number[] = [];

  constructor(private readonly number: ReadNumber) {}

  open(element: Element): void {
    const begun = this.begun(element);
    if (begun) {
      this.group = begun;
      this.properties.groups.set(this.number(element.get('id') ?? ''), begun);
    } else if (element.name === 'texture2d') this.texture(element);
    else if (this.group) this.add(this.group, element);
  }

  private begun(element: Element): PropertyGroup | null {
    switch (element.name) {
      case 'colorgroup':
        return { kind: 'colours', colours: [] };
      case 'basematerials':
        return { kind: 'materials', materials: [] };
      case 'texture2dgroup':
        return { kind: 'picture', texture: this.number(element.get('texid') ?? ''), places: [] };
      case 'compositematerials':
        this.mixed = this.numbers(element.get('matindices'));
        return { kind: 'mixtures', materials: this.number(element.get('matid') ?? ''), chosen: [] };
      case 'multiproperties':
        return { kind: 'layers', groups: this.numbers(element.get('pids')), rows: [] };
      default:
        return null;
    }
  }

  private add(group: PropertyGroup, { name, get }: Element): void {
    if (group.kind === 'colours' && name === 'color') group.colours.push(colourOf(get('color')));
    if (group.kind === 'materials' && name === 'base') {
      group.materials.push({ name: get('name') ?? '', colour: colourOf(get('displaycolor')) });
    }
    if (group.kind === 'picture' && name === 'tex2coord') {
      group.places.push(this.number(get('u') ?? ''), this.number(get('v') ?? ''));
    }
    if (group.kind === 'mixtures' && name === 'composite') {
      group.chosen.push(this.mixed[indexOfLargest(this.numbers(get('values')))] ?? 0);
    }
    if (group.kind === 'layers' && name === 'multi') {
      group.rows.push(this.numbers(get('pindices')));
    }
  }

  private texture({ get }: Element): void {
    const wrapOf = (style = ''): Wrap => tileStyles[style] ?? 'repeat';
    this.properties.textures.set(this.number(get('id') ?? ''), {
      path: get('path') ?? '',
      wrap: [wrapOf(get('tilestyleu')), wrapOf(get('tilestylev'))],
    });
  }

  private numbers(words = ''): number[] {
    return words.split(/\s+/).filter(Boolean).map(this.number);
  }
}
