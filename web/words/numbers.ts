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

/** The form of a word that goes with a number. */
export function choose(number: number, one: string, many: string): string {
  return plurals.select(number) === 'one' ? one : many;
}

/** Longer names are cut in their middle. */
const longestName = 60;

/** A file's name, which may hold anything: without control characters, and not too long for a line. */
export function shown(name: string): string {
  const line = name.replace(/\p{C}/gu, '\u{FFFD}');
  if (line.length <= longestName) return line;
  return `${line.slice(0, longestName / 2)}…${line.slice(1 - longestName / 2)}`;
}

const and = new Intl.ListFormat('en-GB', { type: 'conjunction' });

/** "a.mtl, b.png and c.png" */
export function all(names: readonly string[]): string {
  return and.format(names);
}

/** A sentence with more names is not read. */
const mostNames = 3;

/** The first of the names of files: "a.obj, b.obj, c.obj and 4 more". */
export function some(names: readonly string[]): string {
  const more = names.length - mostNames;
  const first = names.slice(0, mostNames).map(shown);
  return all(more > 0 ? [...first, `${figure(more)} more`] : first);
}

/** "part 3", "parts 1 and 2", "parts 1, 2 and 5" */
export function parts(numbers: readonly number[]): string {
  return `${choose(numbers.length, 'part', 'parts')} ${and.format(numbers.map((part) => figure(part)))}`;
}

/** "piece A", "pieces A, B" */
export function pieces(names: readonly string[]): string {
  return `${choose(names.length, 'piece', 'pieces')} ${names.join(', ')}`;
}
