/** Places in pictures and colours at the vertices of a glTF mesh. */
import type { Accessor, Primitive } from '@gltf-transform/core';
import { ofLight } from '../colours.js';
import type { PlaceTransform } from './base-colour.js';
import { RangeFault } from './range-fault.js';

/** Calls back for each vertex, with its values, which are valid until the next call. */
function eachVertex(
  accessor: Accessor,
  vertices: number,
  take: (values: number[], vertex: number) => void,
): void {
  if (accessor.getCount() !== vertices) throw new RangeFault();
  const values: number[] = [];
  for (let vertex = 0; vertex < vertices; ++vertex) {
    take(accessor.getElement(vertex, values), vertex);
  }
}

/** 2 per vertex, to the right and up, as `Part.looks` has them; in glTF they count down. */
export function placesOf(
  primitive: Primitive,
  name: string,
  { offset, rotation, scale }: PlaceTransform,
  vertices: number,
): Float32Array | null {
  const accessor = primitive.getAttribute(name);
  if (!accessor) return null;
  const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
  const places = new Float32Array(2 * vertices);
  eachVertex(accessor, vertices, ([right = NaN, down = NaN], vertex) => {
    const [x, y] = [scale[0] * right, scale[1] * down];
    places[2 * vertex] = cos * x + sin * y + offset[0];
    places[2 * vertex + 1] = 1 - (cos * y - sin * x + offset[1]);
  });
  return places;
}

/** 3 per vertex, as screens show them; in glTF they are shares of light. */
export function coloursOf(primitive: Primitive, vertices: number): Uint8Array | null {
  const accessor = primitive.getAttribute('COLOR_0');
  if (!accessor) return null;
  const colours = new Uint8Array(3 * vertices);
  eachVertex(accessor, vertices, (values, vertex) => {
    colours.set(ofLight(values), 3 * vertex);
  });
  return colours;
}
