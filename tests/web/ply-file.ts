/** Reads the PLY files that readers write for the engine, of whatever properties. */
import type { Triangles } from './read-model.js';

interface Property {
  name: string;
  type: string;
  isList: boolean;
}

interface Element {
  name: string;
  count: number;
  properties: Property[];
}

function elementsOf(header: string): Element[] {
  const elements: Element[] = [];
  for (const line of header.split('\n')) {
    const words = line.split(' ');
    const name = words.at(-1)!;
    if (words[0] === 'element') elements.push({ name: words[1]!, count: +name, properties: [] });
    if (words[0] !== 'property') continue;
    elements.at(-1)!.properties.push({ name, type: words.at(-2)!, isList: words[1] === 'list' });
  }
  return elements;
}

type Read = (type: string) => number;

function readBinary(bytes: Uint8Array): Read {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  let at = 0;
  return (type) => {
    if (type === 'uchar') return view.getUint8(at++);
    at += 4;
    return type === 'int' ? view.getInt32(at - 4, true) : view.getFloat32(at - 4, true);
  };
}

function readText(bytes: Uint8Array): Read {
  const words = new TextDecoder().decode(bytes).trim().split(/\s+/);
  let next = 0;
  return () => Number(words[next++]);
}

export interface LookedTriangles extends Triangles {
  /** 2 per vertex. */
  places: number[];
  /** 3 per vertex. */
  colours: number[];
  /** Per face. */
  materials: number[];
  /** Numbers of corners, where they are not three. */
  sides: number[];
  /** 2 per corner. */
  cornerPlaces: number[];
}

const listsOf: Readonly<Record<string, keyof LookedTriangles>> = {
  x: 'positions',
  y: 'positions',
  z: 'positions',
  s: 'places',
  t: 'places',
  red: 'colours',
  green: 'colours',
  blue: 'colours',
  vertex_indices: 'corners',
  material: 'materials',
  texcoord: 'cornerPlaces',
};

/** A face as triangles around its first corner. */
function fanOf([first, ...others]: number[]): number[] {
  return others.slice(1).flatMap((corner, i) => [first!, others[i]!, corner]);
}

/** All that a file has; of faces with more corners the triangles. */
export function parsePly(bytes: Uint8Array): LookedTriangles {
  const text = new TextDecoder('latin1').decode(bytes);
  const header = /^ply[^]*?end_header\n/.exec(text)![0];
  const data = bytes.subarray(header.length);
  const read = header.includes('format ascii') ? readText(data) : readBinary(data);
  const found: LookedTriangles = {
    positions: [],
    corners: [],
    places: [],
    colours: [],
    materials: [],
    sides: [],
    cornerPlaces: [],
  };
  for (const { count, properties } of elementsOf(header)) {
    for (let i = 0; i < count; ++i) {
      for (const { name, type, isList } of properties) {
        const length = isList ? read('uchar') : 1;
        const values = Array.from({ length }, () => read(type));
        if (name === 'vertex_indices' && length !== 3) found.sides.push(length);
        found[listsOf[name]!].push(...(name === 'vertex_indices' ? fanOf(values) : values));
      }
    }
  }
  return found;
}
