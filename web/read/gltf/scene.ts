/** The nodes that a glTF file shows, and where they are. */
import type { GLTF } from '@gltf-transform/core';
import { composed, identity, type Affine } from '../matrix.js';
import { RangeFault } from './range-fault.js';

/** A node as it stands in the world. */
export interface PlacedNode {
  node: GLTF.INode;
  index: number;
  map: Affine;
}

/** Far more than there are in any model; nodes that hold themselves would be endless. */
const mostNodes = 200_000;

/** Nodes that hold themselves, or each other. */
export class EndlessScene extends Error {}

/** A 4 x 4 matrix, column by column, without its last row. */
export function affineOf(matrix: ArrayLike<number>, at = 0): Affine {
  return [0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14].map((i) => matrix[at + i]!);
}

/** Of a rotation given as a quaternion, which need not be of unit length, and scales. */
function turned([x, y, z, w]: readonly number[], scale: readonly number[]): number[] {
  const length = Math.hypot(x!, y!, z!, w!);
  const [a, b, c, d] = [x!, y!, z!, w!].map((value) => value / (length || 1)) as [
    number,
    number,
    number,
    number,
  ];
  const columns = [
    [1 - 2 * (b * b + c * c), 2 * (a * b + c * d), 2 * (a * c - b * d)],
    [2 * (a * b - c * d), 1 - 2 * (a * a + c * c), 2 * (b * c + a * d)],
    [2 * (a * c + b * d), 2 * (b * c - a * d), 1 - 2 * (a * a + b * b)],
  ];
  return columns.flatMap((column, i) => column.map((value) => value * scale[i]!));
}

function mapOf({ matrix, translation, rotation, scale }: GLTF.INode): Affine {
  if (matrix) return affineOf(matrix);
  const linear = turned(rotation ?? [0, 0, 0, 1], scale ?? [1, 1, 1]);
  return [...linear, ...(translation ?? [0, 0, 0])];
}

/** The nodes at which the scene begins; without a scene, those that no other one holds. */
function rootsOf({ scene, scenes = [], nodes = [] }: GLTF.IGLTF): number[] {
  const shown = scenes[scene ?? 0];
  if (shown) return shown.nodes ?? [];
  const held = new Set(nodes.flatMap(({ children }) => children ?? []));
  return nodes.map((_, index) => index).filter((index) => !held.has(index));
}

/**
 * All nodes of the default scene, each before those that it holds.
 * @throws EndlessScene, or RangeFault for a node that there is not
 */
export function placedNodes(json: GLTF.IGLTF): PlacedNode[] {
  const nodes = json.nodes ?? [];
  const found: PlacedNode[] = [];
  const waiting = rootsOf(json)
    .map((index) => ({ index, outer: identity, depth: 1 }))
    .reverse();
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const { index, outer, depth } = next;
    const node = nodes[index];
    if (!node) throw new RangeFault();
    const isEndless = depth > nodes.length || found.length + waiting.length > mostNodes;
    if (isEndless) throw new EndlessScene();
    const map = composed(outer, mapOf(node));
    found.push({ node, index, map });
    for (const child of [...(node.children ?? [])].reverse()) {
      waiting.push({ index: child, outer: map, depth: depth + 1 });
    }
  }
  return found;
}
