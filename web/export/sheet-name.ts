/**
 * Name of the file for one sheet, counted from 0, in a format that holds one sheet a file:
 * `OUT.svg` for a single sheet, else `OUT-1.svg`, `OUT-2.svg` and so on. `name` has an ending.
 */
export function sheetName(name: string, sheet: number, count: number): string {
  if (count === 1) return name;
  const dot = name.lastIndexOf('.');
  return `${name.slice(0, dot)}-${sheet + 1}${name.slice(dot)}`;
}
