import type { JobResult, NamedSeam } from '../model/job.js';

/** The seams by their edges of the model. */
export function seamsByEdge({ seams }: Pick<JobResult, 'seams'>): Map<number, NamedSeam> {
  return new Map(seams.flatMap((seam) => Array.from(seam.modelEdges, (edge) => [edge, seam])));
}

/** The number in a text such as 12, Wing:12 or C12; null for a text that is none. */
export function numberIn(text: string): string | null {
  return /\d+$/.exec(text)?.[0] ?? null;
}

/**
 * The numbers that are printed at seams, by their edges of the model. Seams whose number does not
 * stand at both sides have none. Numbers of seams between the same two pieces differ.
 */
export function seamNumbers(result: JobResult): Map<number, string> {
  const { printed, skipped } = result.ids;
  if (printed === 0) return new Map();
  const isLeftOut = new Set(skipped);
  const numbers = new Map<number, string>();
  for (const [edge, { name }] of seamsByEdge(result)) {
    if (!isLeftOut.has(name)) numbers.set(edge, numberIn(name)!);
  }
  return numbers;
}

/** Numbers in the order in which they are used, each once where it is used on and on: 12–17, 20, 9–7. */
export function numberRuns(numbers: readonly string[]): string[] {
  const runs: { from: number; to: number; step: number }[] = [];
  for (const number of numbers.map(Number)) {
    const last = runs.at(-1);
    if (last?.to === number) continue;
    const step = last ? number - last.to : 0;
    if (last && Math.abs(step) === 1 && (last.step === 0 || last.step === step)) {
      Object.assign(last, { to: number, step });
    } else {
      runs.push({ from: number, to: number, step: 0 });
    }
  }
  return runs.flatMap(({ from, to }) => {
    if (from === to) return [`${from}`];
    return Math.abs(to - from) === 1 ? [`${from}`, `${to}`] : [`${from}–${to}`];
  });
}
