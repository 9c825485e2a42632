import type { EdgeLock } from '../model/job-options.js';
import { facesBeside, facing, trianglesOf } from '../model/facing.js';
import type { FindingPlace } from '../model/finding-places.js';
import type { SheetEdge, SheetEdges, SheetPoint } from '../model/sheet-edges.js';
import { gripOf, type SheetFlap } from '../model/sheet-flaps.js';
import type { Vector } from '../model/vector.js';
import type { EdgeLight } from '../view/edge-lights.js';
import type { LockSign } from '../view/lock-signs.js';

/** Signs of locks by sheet, counted from 0. */
export type LocksBySheet = ReadonlyMap<number, LockSign[]>;

/** The signs of locked edges; a cut has one at each of its sides. */
export function lockSigns(
  titles: Readonly<Record<'fold' | 'cut', string>>,
  edges: SheetEdges,
  locks: readonly EdgeLock[],
): LocksBySheet {
  const signs = new Map<number, LockSign[]>();
  for (const { from: v, to: w, as } of locks) {
    const edge = edges.find([v, w]);
    const partner = edge && edges.partnerOf(edge);
    for (const { sheet, from, to } of [edge, partner].filter((one) => one !== null)) {
      signs.set(sheet, [...(signs.get(sheet) ?? []), { as, title: titles[as], from, to }]);
    }
  }
  return signs;
}

/** Lights by sheet, counted from 0. */
export type LightsBySheet = ReadonlyMap<number, EdgeLight[]>;

function middleOf(side: readonly SheetEdge[]): SheetPoint {
  const ends = side.flatMap(({ from, to }) => [from, to]);
  const mean = (axis: 0 | 1): number =>
    ends.reduce((sum, end) => sum + end[axis], 0) / Math.max(1, ends.length);
  return [mean(0), mean(1)];
}

/** An edge with all that has its number, what that is glued to, and on the same sheet an arc between the two. */
export function edgeLighting(edges: SheetEdges, edge: SheetEdge): LightsBySheet {
  const lights = new Map<number, EdgeLight[]>();
  const add = (sheet: number, light: EdgeLight): void => {
    lights.set(sheet, [...(lights.get(sheet) ?? []), light]);
  };
  const own = edges.side(edge);
  const partner = edges.partnerOf(edge);
  const other = partner ? edges.side(partner) : [];
  for (const { sheet, from, to } of own) add(sheet, { kind: 'own', from, to });
  for (const { sheet, from, to } of other) add(sheet, { kind: 'partner', from, to });
  if (partner?.sheet === edge.sheet) {
    add(edge.sheet, { kind: 'way', from: middleOf(own), to: middleOf(other) });
  }
  return lights;
}

/** The grip of a flap: a line of no length, of which its round ends are seen. */
export function gripLighting(flap: SheetFlap): LightsBySheet {
  const at = gripOf(flap);
  return new Map([[flap.sheet, [{ kind: 'grip', from: at, to: at }]]]);
}

/** A piece by its whole outline. */
export function pieceLighting({ all }: SheetEdges, piece: number): LightsBySheet {
  const outline = outlineOf(all, piece);
  const lights = outline.map(({ from, to }): EdgeLight => ({ kind: 'own', from, to }));
  return new Map(outline.slice(0, 1).map(({ sheet }) => [sheet, lights]));
}

function outlineOf(all: readonly SheetEdge[], piece: number): SheetEdge[] {
  return all.filter((one) => one.piece === piece && (one.kind === 'cut' || one.kind === 'border'));
}

/** What is lit of the model: vertices of edges, 2 each, in the order of the side that is meant. */
export function litOnModel(edges: SheetEdges, place: FindingPlace): number[] {
  const lit = place.edge ? edges.side(place.edge) : outlineOf(edges.all, place.piece);
  return lit.flatMap(({ name }) => [...name]);
}

/** From where a place is seen on the model, if nothing else of it is in the way. */
export function viewOf({ result: { model, pieces } }: SheetEdges, place: FindingPlace): Vector {
  const faces = place.edge
    ? facesBeside(model, place.edge.name)
    : [...pieces[place.piece]!.sources];
  return facing(trianglesOf(model, faces));
}

/** Several lightings in one. */
export function together(lightings: readonly LightsBySheet[]): LightsBySheet {
  const lights = new Map<number, EdgeLight[]>();
  for (const [sheet, more] of lightings.flatMap((one) => [...one])) {
    lights.set(sheet, [...(lights.get(sheet) ?? []), ...more]);
  }
  return lights;
}
