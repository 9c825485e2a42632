/** Where on the sheets is what a finding is about. */
import { edgeLength } from './borders.js';
import type { JobResult, NamedSeam } from './job.js';
import { bareSeams, measureSeams } from './seam-measures.js';
import type { SheetEdge, SheetEdges } from './sheet-edges.js';
import { goodSeam } from './short-seams.js';
import type { Finding, FindingCode } from './verdict.js';

/** An edge, or a whole piece by its index. */
export type FindingPlace = { edge: SheetEdge; piece?: never } | { edge?: never; piece: number };

/** mm by which a fold and the length of a neck may differ. */
const sameLength = 1e-6;

function atSeams(edges: SheetEdges, seams: readonly NamedSeam[]): FindingPlace[] {
  const first = new Map<NamedSeam, SheetEdge>();
  for (const edge of edges.all) {
    if (edge.seam && !first.has(edge.seam)) first.set(edge.seam, edge);
  }
  return seams.flatMap((seam) => {
    const edge = first.get(seam);
    return edge ? [{ edge }] : [];
  });
}

/** The shortest first: they are the hardest. */
function shortSeams(result: JobResult): NamedSeam[] {
  const short = measureSeams(result).filter(({ length }) => length < goodSeam);
  return short.sort((a, b) => a.length - b.length).map(({ seam }) => seam);
}

/** The narrowest first. The engine tells how long the folds are that are too short for what hangs at them, but not which. */
function atNecks({ all, result }: SheetEdges): FindingPlace[] {
  const lengthOf = ({ piece, edge }: SheetEdge): number => edgeLength(result.pieces[piece]!, edge);
  const isNeck = (edge: SheetEdge): boolean => {
    const length = lengthOf(edge);
    return result.pieces[edge.piece]!.necks.some((neck) => Math.abs(neck - length) < sameLength);
  };
  return all
    .filter((edge) => (edge.kind === 'mountain' || edge.kind === 'valley') && isNeck(edge))
    .sort((a, b) => lengthOf(a) - lengthOf(b))
    .map((edge) => ({ edge }));
}

const ofWholeModel: ReadonlySet<FindingCode> = new Set<FindingCode>([
  'unfinished',
  'run-stopped',
  'long-building',
]);

/** Whether a finding is about places, rather than about the whole model. */
export function hasPlaces({ code, count }: Finding): boolean {
  return count > 0 && !ofWholeModel.has(code);
}

/**
 * The places of what a finding is about, in the order in which a person looks at them; none where it is about the
 * whole model.
 */
export function placesOf(finding: Finding, edges: SheetEdges): FindingPlace[] {
  const { result } = edges;
  const named = (names: readonly string[]): FindingPlace[] =>
    result.pieces.flatMap(({ name }, piece) => (names.includes(name) ? [{ piece }] : []));
  const seams = (names: readonly string[]): FindingPlace[] =>
    atSeams(
      edges,
      result.seams.filter(({ name }) => names.includes(name)),
    );
  switch (finding.code) {
    case 'overlapping-pieces':
    case 'beyond-paper':
    case 'missing-names':
    case 'tiny-pieces':
    case 'unproved-folding':
      return named(finding.params.pieces);
    case 'weak-necks': {
      const necks = atNecks(edges);
      // A neck along several short edges is as long as none of them.
      return necks.length > 0 ? necks : named(finding.params.pieces);
    }
    case 'short-seams':
      return atSeams(edges, shortSeams(result));
    case 'missing-flaps':
      return atSeams(
        edges,
        bareSeams(result).map(({ seam }) => seam),
      );
    case 'missing-numbers':
      return seams(result.ids.skipped);
    case 'spare-sheet': {
      const last = result.sheets.length - 1;
      return result.pieces.flatMap(({ sheet }, piece) => (sheet === last ? [{ piece }] : []));
    }
    case 'unfinished':
    case 'run-stopped':
    case 'long-building':
      return [];
  }
}
