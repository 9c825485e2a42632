/** Name of a piece for people, from its index: A, B, .. Z, AA, AB, .. as in the columns of a sheet. */
export function pieceLetter(index: number): string {
  const last = String.fromCharCode(65 + (index % 26));
  return index < 26 ? last : pieceLetter(Math.floor(index / 26) - 1) + last;
}
