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

/** The first names and how many more there are: a longer list is not read. */
function first(names: readonly string[], most: number): string[] {
  const more = names.length - most;
  return more > 0 ? [...names.slice(0, most), `${figure(more)} more`] : [...names];
}

/** The first of the names of files: "a.obj, b.obj, c.obj and 4 more". */
export function some(names: readonly string[]): string {
  return all(first(names.map(shown), 3));
}

/** "part 3", "parts 1 and 2", "parts 1, 2 and 5" */
export function parts(numbers: readonly number[]): string {
  return `${choose(numbers.length, 'part', 'parts')} ${and.format(numbers.map((part) => figure(part)))}`;
}

const mostPieces = 12;

/** "piece A", "pieces A, B", "pieces A, B, ... and 7 more" */
export function pieces(names: readonly string[]): string {
  const list = names.length > mostPieces ? all(first(names, mostPieces)) : names.join(', ');
  return `${choose(names.length, 'piece', 'pieces')} ${list}`;
}
