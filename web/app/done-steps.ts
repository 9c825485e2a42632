/** Where things are kept for the next visit: `localStorage`. */
export type Shelf = Pick<Storage, 'getItem' | 'setItem'>;

const memory = 'foldwright.steps';

/** Results of which it is remembered what is done, and steps of each: together less than 50 kB. */
const [mostResults, mostSteps] = [40, 1000];

/** A result's hash, and 1 or 0 for each of its steps. */
type Entry = readonly [hash: string, steps: string];

function isEntry(entry: unknown): entry is Entry {
  return (
    Array.isArray(entry) &&
    typeof entry[0] === 'string' &&
    typeof entry[1] === 'string' &&
    /^[01]*$/.test(entry[1])
  );
}

/** Building steps that a person has ticked off, by the hash of the result. A browser that keeps nothing forgets them. */
export class DoneSteps {
  /** @param shelf may throw, as browsers do that keep nothing */
  constructor(private readonly shelf: () => Shelf) {}

  /** Steps of a result that are done, from 0. */
  of(hash: string): Set<number> {
    const steps = this.read().find(([other]) => other === hash)?.[1] ?? '';
    return new Set([...steps].flatMap((isDone, step) => (isDone === '1' ? [step] : [])));
  }

  /** Remembers whether a step is done. The results that were used last are kept. */
  set(hash: string, step: number, isDone: boolean): void {
    if (step >= mostSteps) return;
    const done = this.of(hash);
    if (isDone) done.add(step);
    else done.delete(step);
    const others = this.read().filter(([other]) => other !== hash);
    const length = Math.max(-1, ...done) + 1;
    const steps = Array.from({ length }, (_, i) => (done.has(i) ? '1' : '0')).join('');
    const entries = length > 0 ? [...others, [hash, steps]] : others;
    try {
      this.shelf().setItem(memory, JSON.stringify(entries.slice(-mostResults)));
    } catch {
      // It is remembered no longer than the page, which has its own ticks.
    }
  }

  private read(): Entry[] {
    try {
      const kept: unknown = JSON.parse(this.shelf().getItem(memory) ?? '[]');
      return Array.isArray(kept) ? kept.filter(isEntry) : [];
    } catch {
      return [];
    }
  }
}
