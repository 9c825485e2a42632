import type { JobResult } from './job.js';

/** For each part those that it shares an edge of the model with. */
export type Neighbours = readonly ReadonlySet<number>[];

/** Which parts touch. */
export function partNeighbours({
  model,
  labels,
  parts,
}: Pick<JobResult, 'model' | 'labels' | 'parts'>): Neighbours {
  const neighbours = Array.from({ length: parts }, () => new Set<number>());
  const vertices = model.vertices.length / 3;
  /** The part of the first face of each edge. */
  const sides = new Map<number, number>();
  model.faces.forEach((from, corner) => {
    const to = model.faces[corner % 3 === 2 ? corner - 2 : corner + 1]!;
    const part = labels[Math.floor(corner / 3)]!;
    const edge = Math.min(from, to) * vertices + Math.max(from, to);
    const other = sides.get(edge) ?? part;
    sides.set(edge, other);
    if (other === part) return;
    neighbours[part]!.add(other);
    neighbours[other]!.add(part);
  });
  return neighbours;
}

/** Whether one can go from each of these parts to each other one without leaving them. */
export function hangTogether(neighbours: Neighbours, chosen: readonly number[]): boolean {
  const reached = new Set(chosen.slice(0, 1));
  // A set that grows is walked to its end.
  for (const part of reached) {
    for (const next of chosen) if (neighbours[part]!.has(next)) reached.add(next);
  }
  return reached.size === new Set(chosen).size;
}
