/** Numbers and lists as English has them. */

const plurals = new Intl.PluralRules('en');

/** A number as it is, without marks between thousands. */
export function figure(value: number, mostDigits = 20): string {
  return new Intl.NumberFormat('en', {
    useGrouping: false,
    maximumFractionDigits: mostDigits,
  }).format(value);
}

/** A length in units of the model: "0.0023". */
export function rounded(value: number): string {
  return new Intl.NumberFormat('en', { useGrouping: false, maximumSignificantDigits: 2 }).format(
    value,
  );
}

/** "1 edge", "2 edges" */
export function count(number: number, one: string, many = `${one}s`): string {
  return `${figure(number)} ${choose(number, one, many)}`;
}

/** "7 %", "less than 1 %" */
export function percentage(percent: number): string {
  return percent < 1 ? 'less than 1 %' : `${figure(percent)} %`;
}

/** The form of a word that goes with a number. */
export function choose(number: number, one: string, many: string): string {
  return plurals.select(number) === 'one' ? one : many;
}

const and = new Intl.ListFormat('en-GB', { type: 'conjunction' });

/** "a.mtl, b.png and c.png" */
export function all(names: readonly string[]): string {
  return and.format(names);
}

/** "part 3", "parts 1 and 2", "parts 1, 2 and 5" */
export function parts(numbers: readonly number[]): string {
  return `${choose(numbers.length, 'part', 'parts')} ${and.format(numbers.map((part) => figure(part)))}`;
}

/** A longer list is not read. */
const mostNames = 12;

/** "A, B, C", "A, B, ... and 7 more" */
function some(names: readonly string[]): string {
  const more = names.length - mostNames;
  return more > 0
    ? `${names.slice(0, mostNames).join(', ')} and ${figure(more)} more`
    : names.join(', ');
}

/** "piece A", "pieces A, B" */
export function pieces(names: readonly string[]): string {
  return `${choose(names.length, 'piece', 'pieces')} ${some(names)}`;
}
