import type { SheetEdge, SheetEdges, SheetPoint } from '../model/sheet-edges.js';
import type { EdgeLight } from '../view/edge-lights.js';

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

/** Several lightings in one. */
export function together(lightings: readonly LightsBySheet[]): LightsBySheet {
  const lights = new Map<number, EdgeLight[]>();
  for (const [sheet, more] of lightings.flatMap((one) => [...one])) {
    lights.set(sheet, [...(lights.get(sheet) ?? []), ...more]);
  }
  return lights;
}
