import type { AssemblyStep } from '../model/assembly-steps.js';
import type { Piece } from '../model/job.js';
import type { MarkKind, SheetMark } from '../view/sheet-marks.js';

/** Marks by sheet, counted from 0. */
export type MarksBySheet = ReadonlyMap<number, SheetMark[]>;

/** What a step is about, where it lies on the sheets; a seam has its number where it begins. */
export function stepMarks(step: AssemblyStep, pieces: readonly Piece[]): MarksBySheet {
  const marks = new Map<number, SheetMark[]>();
  const add = (kind: MarkKind, index: number, edge: number, label?: string): void => {
    const { edges, sheet, vertices, x, y } = pieces[index]!;
    const [from, to] = [edges[2 * edge]!, edges[2 * edge + 1]!].map(
      (vertex) => [x + vertices[2 * vertex]!, y + vertices[2 * vertex + 1]!] as const,
    );
    const mark = { kind, from: from!, to: to!, ...(label && { label }) };
    marks.set(sheet, [...(marks.get(sheet) ?? []), mark]);
  };
  for (const edge of step.turn) add('turn', step.piece, edge);
  for (const pair of step.borders) for (const { piece, edge } of pair) add('border', piece, edge);
  step.seams.forEach((seam, i) => {
    seam.forEach((pair, at) => {
      for (const edge of pair) add('seam', step.piece, edge, at === 0 ? String(i + 1) : undefined);
    });
  });
  return marks;
}
