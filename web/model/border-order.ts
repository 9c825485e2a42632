import { edgeLength, type CutSide } from './borders.js';
import type { AssemblyStep } from './assembly-steps.js';
import type { JobResult } from './job.js';
import { modelVertices } from './model-vertices.js';

/** Two edges that are glued to each other. */
export type Border = readonly [CutSide, CutSide];

/** A border between two vertices of the model. */
interface Link {
  border: Border;
  ends: readonly [number, number];
  length: number;
}

/** Chains of borders that follow each other; a chain ends where it forks or where nothing follows. */
class Chains {
  private readonly around = new Map<number, Link[]>();
  private readonly left: Set<Link>;

  constructor(links: readonly Link[]) {
    this.left = new Set(links);
    for (const link of links) {
      for (const end of link.ends) this.around.set(end, [...(this.around.get(end) ?? []), link]);
    }
  }

  all(): Link[][] {
    const chains: Link[][] = [];
    // Ends first, so that what is left are loops.
    for (const link of this.left) {
      const end = link.ends.find((vertex) => this.around.get(vertex)!.length !== 2);
      if (end !== undefined && this.left.has(link)) chains.push(this.from(link, end));
    }
    while (this.left.size > 0) {
      const longest = [...this.left].reduce((a, b) => (b.length > a.length ? b : a));
      chains.push(this.from(longest, longest.ends[0]));
    }
    return chains;
  }

  /** Takes the chain that a link begins at this end. */
  private from(first: Link, end: number): Link[] {
    const chain: Link[] = [];
    let [link, at]: [Link | undefined, number] = [first, end];
    while (link) {
      chain.push(link);
      this.left.delete(link);
      at = link.ends[0] === at ? link.ends[1] : link.ends[0];
      const around: Link[] = this.around.get(at)!;
      link = around.length === 2 ? around.find((other) => this.left.has(other)) : undefined;
    }
    return chain;
  }
}

/**
 * The borders of a step in an order in which hands can glue them: along the longest stretch that hangs
 * together, each beside the one before, then along the next longest. A stretch begins at one of its ends;
 * a loop at its longest edge, which is laid down most surely.
 *
 * @returns every border of the step once
 */
export function borderOrder({ model, pieces }: JobResult, step: AssemblyStep): Border[] {
  const vertices = modelVertices(pieces[step.piece]!, model);
  const links = step.borders.map((border): Link => {
    const side = border[0].piece === step.piece ? border[0] : border[1];
    const { edges } = pieces[step.piece]!;
    return {
      border,
      ends: [vertices[edges[2 * side.edge]!]!, vertices[edges[2 * side.edge + 1]!]!],
      length: edgeLength(pieces[step.piece]!, side.edge),
    };
  });
  const lengthOf = (chain: readonly Link[]): number =>
    chain.reduce((sum, { length }) => sum + length, 0);
  return new Chains(links)
    .all()
    .sort((a, b) => lengthOf(b) - lengthOf(a))
    .flatMap((chain) => chain.map(({ border }) => border));
}
