/** One part of a 3MF package that holds objects (3MF core 1.3, sections 3 and 4). */
import { identity, type Affine } from '../matrix.js';
import { TextPrecision } from '../precision.js';
import { mostTriangles } from '../soup.js';
import { unreadable } from '../unreadable.js';
import { PropertyListener, type Properties } from './properties.js';
import { TriangleProperties, type TriangleProperty } from './triangle-properties.js';
import { parseXml, type Element, type XmlListener } from './xml.js';

export interface Mesh {
  /** 3 per vertex. */
  positions: number[];
  /** 3 per triangle. */
  triangles: number[];
  precision: TextPrecision;
  properties: TriangleProperties;
}

/** Another object, as a part of one or on the printer's bed. */
export interface Placement {
  object: string;
  /** The part that it is in, if another one. */
  path: string | null;
  map: Affine;
  /** Whether a slicer was told not to print it. */
  isOff: boolean;
}

export interface ThreeMfObject {
  type: string;
  mesh: Mesh;
  components: Placement[];
}

export interface ModelPart {
  /** Millimetres in one unit. */
  unit: number;
  /** By their numbers. */
  objects: Map<string, ThreeMfObject>;
  items: Placement[];
  properties: Properties;
  /** Extensions that must be known and are not, as the part calls them. */
  unknown: string[];
}

const family = 'http://schemas.microsoft.com/3dmanufacturing/';
const core = `${family}core/`;
const production = `${family}production/`;

/** Extensions whose content is read, or leaves the shape as it is. */
const known = [core, production, `${family}material/`, `${family}trianglesets/`];

const units: Readonly<Record<string, number>> = {
  micron: 0.001,
  millimeter: 1,
  centimeter: 10,
  inch: 25.4,
  foot: 304.8,
  meter: 1000,
};

const usualType = 'model';

const none = { group: -1, index: -1 };

/** Takes in the elements of a part. */
class PartListener implements XmlListener {
  private readonly looks = new PropertyListener((word) => this.number(word));
  readonly part: ModelPart = {
    unit: 1,
    objects: new Map(),
    items: [],
    properties: this.looks.properties,
    unknown: [],
  };
  private object: ThreeMfObject | null = null;
  /** What triangles of the object have that say nothing else; -1 for none. */
  private usual = none;

  constructor(
    private readonly file: string,
    private readonly path: string,
    private readonly line: () => number,
  ) {}

  open(element: Element): void {
    const { name, uri } = element;
    this.looks.open(element);
    if (!uri.startsWith(core)) return;
    if (name === 'vertex') this.vertex(element);
    else if (name === 'triangle') this.triangle(element);
    else if (name === 'object') this.begin(element);
    else if (name === 'component') this.object?.components.push(this.placement(element));
    else if (name === 'item') this.part.items.push(this.placement(element));
    else if (name === 'model') this.model(element);
  }

  close(uri: string, name: string): void {
    if (name === 'object' && uri.startsWith(core)) this.object = null;
  }

  private model(element: Element): void {
    const unit = element.get('unit') ?? 'millimeter';
    this.part.unit = units[unit] ?? this.fail(unit);
    for (const prefix of (element.get('requiredextensions') ?? '').split(/\s+/).filter(Boolean)) {
      const uri = element.namespace(prefix) ?? '';
      if (!known.some((begin) => uri.startsWith(begin))) this.part.unknown.push(uri || prefix);
    }
  }

  private begin(element: Element): void {
    const mesh = {
      positions: [],
      triangles: [],
      precision: new TextPrecision(),
      properties: new TriangleProperties(),
    };
    this.usual = { group: this.index(element, 'pid'), index: this.index(element, 'pindex') };
    this.object = { type: element.get('type') ?? usualType, mesh, components: [] };
    this.part.objects.set(element.get('id') ?? '', this.object);
  }

  private vertex(element: Element): void {
    const mesh = this.object?.mesh;
    for (const axis of ['x', 'y', 'z']) {
      const word = element.get(axis) ?? '';
      const value = this.number(word);
      mesh?.positions.push(value);
      mesh?.precision.add(word, value);
    }
  }

  private triangle(element: Element): void {
    const triangles = this.object?.mesh.triangles;
    for (const corner of ['v1', 'v2', 'v3']) {
      const word = element.get(corner) ?? '';
      triangles?.push(/^\s*\d+\s*$/.test(word) ? Number(word) : this.fail(word));
    }
    if (!triangles) return;
    if (triangles.length > 3 * mostTriangles) {
      throw unreadable('too-many-triangles', { most: mostTriangles });
    }
    const property = this.property(element);
    if (property.group === -1) return;
    this.object?.mesh.properties.set(triangles.length / 3 - 1, property);
  }

  /** What a triangle says, or else its object: the first corner speaks for those that say nothing. */
  private property(element: Element): TriangleProperty {
    const first = this.index(element, 'p1');
    const { group, index } = this.usual;
    if (first === -1) return { group, corners: [index, index, index] };
    const [second, third] = [this.index(element, 'p2', first), this.index(element, 'p3', first)];
    return { group: this.index(element, 'pid', group), corners: [first, second, third] };
  }

  private index(element: Element, name: string, usual = -1): number {
    const word = element.get(name);
    return word === undefined ? usual : this.number(word);
  }

  private placement(element: Element): Placement {
    return {
      object: element.get('objectid') ?? '',
      path: element.get('path', `${production}2015/06`) ?? null,
      map: this.map(element.get('transform')),
      isOff: element.get('printable') === '0',
    };
  }

  private map(transform: string | undefined): Affine {
    if (transform === undefined) return identity;
    const numbers = transform
      .trim()
      .split(/\s+/)
      .map((word) => this.number(word));
    return numbers.length === 12 ? numbers : this.fail(transform);
  }

  private number(word: string): number {
    const value = word.trim() === '' ? NaN : Number(word);
    return Number.isFinite(value) ? value : this.fail(word);
  }

  private fail(word: string): never {
    const { file, path } = this;
    throw unreadable('bad-3mf', {
      file,
      what: 'word',
      part: path,
      line: this.line(),
      word: word.slice(0, 40),
    });
  }
}

/** @throws Unreadable for words that are no numbers, and BadXml */
export function readModelPart(file: string, path: string, bytes: Uint8Array): ModelPart {
  let listener: PartListener | undefined;
  parseXml(bytes, (line) => (listener = new PartListener(file, path, line)));
  return listener!.part;
}
