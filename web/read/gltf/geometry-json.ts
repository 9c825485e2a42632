/**
 * The part of a glTF file that decides its shape, and where its pictures and colours lie on it. All else is left out
 * before the file is decoded, so that a broken picture or animation, and a buffer that only those need, do no harm.
 */
import type { GLTF } from '@gltf-transform/core';
import { baseColourOf } from './base-colour.js';
import { sortedExtensions, withKnownNames } from './extensions.js';
import { mostTriangles } from '../soup.js';
import { RangeFault } from './range-fault.js';

/** Numbers of all accessors together: above three corners with nine numbers for all triangles that are read. */
const mostNumbers = 30 * mostTriangles;

/** What decides the shape. */
const attribute = /^(?:POSITION|JOINTS_\d+|WEIGHTS_\d+)$/;

const draco = 'KHR_draco_mesh_compression';
const meshopt = 'EXT_meshopt_compression';

/** Numbers per element of an accessor. */
const elementSizes: Readonly<Record<string, number>> = {
  SCALAR: 1,
  VEC2: 2,
  VEC3: 3,
  VEC4: 4,
  MAT2: 4,
  MAT3: 9,
  MAT4: 16,
};

interface MeshoptView {
  buffer: number;
  count: number;
  byteStride: number;
}

interface DracoPrimitive {
  bufferView: number;
  attributes: Record<string, number>;
}

/** A list of which only some entries are kept, under new numbers. */
class Kept<Value> {
  readonly values: Value[] = [];
  private readonly numbers = new Map<number, number>();

  constructor(
    private readonly all: readonly Value[],
    private readonly keep: (value: Value) => Value,
  ) {}

  /** The new number of an entry. @throws RangeFault for one that there is not */
  of(index: number): number {
    const known = this.numbers.get(index);
    if (known !== undefined) return known;
    const value = this.all[index];
    if (value === undefined) throw new RangeFault();
    const number = this.values.push(this.keep(value)) - 1;
    this.numbers.set(index, number);
    return number;
  }
}

/** What is kept of a file, and how its parts are numbered now. */
export interface GeometryJson {
  json: GLTF.IGLTF;
  /** Buffers of the file, as the kept ones are numbered. */
  buffers: GLTF.IBuffer[];
  /** Per skin: where the matrices that undo its pose are. */
  skinAccessors: (number | null)[];
}

function keptOf(
  attributes: Record<string, number> | undefined,
  looks: readonly string[],
): [string, number][] {
  return Object.entries(attributes ?? {}).filter(
    ([name]) => attribute.test(name) || looks.includes(name),
  );
}

class Reduction {
  private readonly buffers: Kept<GLTF.IBuffer>;
  private readonly views: Kept<GLTF.IBufferView>;
  private readonly accessors: Kept<GLTF.IAccessor>;
  private numbers = 0;

  constructor(
    private readonly json: GLTF.IGLTF,
    private readonly withLooks: boolean,
  ) {
    this.buffers = new Kept(json.buffers ?? [], (buffer) => buffer);
    this.views = new Kept(json.bufferViews ?? [], (view) => this.view(withKnownNames(view)));
    this.accessors = new Kept(json.accessors ?? [], (accessor) => this.accessor(accessor));
  }

  run(): GeometryJson {
    const { json } = this;
    const meshes = (json.meshes ?? []).map((mesh) => this.mesh(mesh));
    const skinAccessors = (json.skins ?? []).map(({ inverseBindMatrices }) =>
      inverseBindMatrices === undefined ? null : this.accessors.of(inverseBindMatrices),
    );
    const { read } = sortedExtensions(json.extensionsUsed ?? [], json.extensionsRequired ?? []);
    return {
      json: {
        asset: { version: '2.0' },
        extensionsUsed: read,
        meshes,
        accessors: this.accessors.values,
        bufferViews: this.views.values,
      },
      buffers: this.buffers.values,
      skinAccessors,
    };
  }

  private count(numbers: number): void {
    this.numbers += numbers;
    if (!(numbers >= 0) || this.numbers > mostNumbers) throw new RangeFault();
  }

  private mesh({ weights, primitives }: GLTF.IMesh): GLTF.IMesh {
    return {
      ...(weights && { weights }),
      primitives: primitives.map((each) => this.primitive(each)),
    };
  }

  private primitive(primitive: GLTF.IMeshPrimitive): GLTF.IMeshPrimitive {
    const { mode, indices, targets } = primitive;
    const compressed = primitive.extensions?.[draco] as DracoPrimitive | undefined;
    const looks = this.looksOf(primitive);
    return {
      ...(mode !== undefined && { mode }),
      ...(indices !== undefined && { indices: this.accessors.of(indices) }),
      attributes: this.attributes(primitive.attributes, looks),
      ...(targets && { targets: targets.map((target) => this.attributes(target)) }),
      ...(compressed && { extensions: { [draco]: this.dracoPrimitive(compressed, looks) } }),
    };
  }

  /** Attributes for how a primitive looks. */
  private looksOf({ material }: GLTF.IMeshPrimitive): string[] {
    if (!this.withLooks) return [];
    const { picture } = baseColourOf(this.json, material);
    return picture ? ['COLOR_0', picture.places] : ['COLOR_0'];
  }

  private attributes(
    attributes: Record<string, number> | undefined,
    looks: readonly string[] = [],
  ): Record<string, number> {
    const kept = keptOf(attributes, looks);
    return Object.fromEntries(kept.map(([name, accessor]) => [name, this.accessors.of(accessor)]));
  }

  private dracoPrimitive(
    { bufferView, attributes }: DracoPrimitive,
    looks: readonly string[],
  ): DracoPrimitive {
    const kept = keptOf(attributes, looks);
    return { bufferView: this.views.of(bufferView), attributes: Object.fromEntries(kept) };
  }

  private accessor(accessor: GLTF.IAccessor): GLTF.IAccessor {
    const { bufferView, sparse, count, type } = accessor;
    this.count(count * (elementSizes[type] ?? NaN));
    return {
      ...accessor,
      ...(bufferView !== undefined && { bufferView: this.views.of(bufferView) }),
      ...(sparse && { sparse: this.sparse(sparse, count) }),
    };
  }

  private sparse(sparse: GLTF.IAccessorSparse, count: number): GLTF.IAccessorSparse {
    if (!(sparse.count <= count)) throw new RangeFault();
    const { indices, values } = sparse;
    return {
      ...sparse,
      indices: { ...indices, bufferView: this.views.of(indices.bufferView) },
      values: { ...values, bufferView: this.views.of(values.bufferView) },
    };
  }

  private view(view: GLTF.IBufferView): GLTF.IBufferView {
    const compressed = view.extensions?.[meshopt] as MeshoptView | undefined;
    if (!compressed) return { ...view, buffer: this.buffers.of(view.buffer) };
    this.count(compressed.count * compressed.byteStride);
    const buffer = this.buffers.of(compressed.buffer);
    // What stands in for it where it cannot be decoded is not needed.
    return { ...view, buffer, extensions: { [meshopt]: { ...compressed, buffer } } };
  }
}

/**
 * @param withLooks whether attributes for looks are kept
 * @throws RangeFault for numbers that lead nowhere, or to far too much
 */
export function geometryJson(json: GLTF.IGLTF, withLooks: boolean): GeometryJson {
  return new Reduction(json, withLooks).run();
}
