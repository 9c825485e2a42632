/** What a result has no room for, in phrases for people: names, flaps and numbers. */
import type { FlapCounts, JobResult } from './job.js';

function count(number: number, noun: string): string {
  return `${number} ${noun}${number === 1 ? '' : 's'}`;
}

/** Why seams have no flap, with what that means. */
const missWords: Readonly<Record<keyof FlapCounts['missing'], string>> = {
  narrow: 'in wedges too narrow for one',
  thin: 'where the neighbouring face is too thin to hide one',
  blocked: 'where something else of the piece is in the way',
  short: 'too short for one',
};

/** The seams without a flap, by why there is none. */
function missingFlaps({ flaps: { missing, missing_mm, wanted_mm } }: JobResult): string[] {
  const classes = (Object.keys(missWords) as (keyof typeof missing)[]).filter(
    (name) => missing[name] > 0,
  );
  if (classes.length === 0) return [];
  const all = classes.reduce((sum, name) => sum + missing[name], 0);
  const reasons = classes.map((name) => `${missing[name]} ${missWords[name]}`);
  const share = Math.round((100 * missing_mm) / wanted_mm);
  return [
    `no flap on ${count(all, 'seam')}: ${reasons.join(', ')}. That is ${share} % of the length of all ` +
      'seams; close them with tape or strips of paper from inside',
  ];
}

/** The seams without a number at one side at least. */
function missingIds({ ids: { skipped } }: JobResult): string[] {
  if (skipped.length === 0) return [];
  const numbers = new Map<string, string[]>(); // by the pieces that meet there
  for (const id of skipped) {
    const [pieces, number] = id.split(':') as [string, string];
    numbers.set(pieces, [...(numbers.get(pieces) ?? []), number]);
  }
  const names = [...numbers].map(([pieces, all]) => `${pieces}: ${all.join(', ')}`).join('; ');
  return [
    `no room for a readable number at both sides of ${count(skipped.length, 'seam')}: ${names}`,
  ];
}

/** The pieces that do not say which they are. */
function missingNames({ pieces }: JobResult): string[] {
  const nameless = pieces.filter(({ name, labels }) => labels.every(({ text }) => text !== name));
  if (nameless.length === 0) return [];
  const names = nameless.map(({ name }) => name).join(', ');
  const [piece, it] = nameless.length === 1 ? ['piece', 'its name'] : ['pieces', 'their names'];
  return [`no room for ${it} on ${piece} ${names}; short names need less`];
}

/** One phrase for each kind of thing that is left out; none if nothing is. */
export function leftOut(result: JobResult): string[] {
  return [...missingNames(result), ...missingFlaps(result), ...missingIds(result)];
}
