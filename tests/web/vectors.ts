/** Vectors of any dimension for the judges of written files, which share nothing with the product. */
export type Vector = number[];

export const minus = (a: Vector, b: Vector): Vector => a.map((value, i) => value - b[i]!);
export const dot = (a: Vector, b: Vector): number =>
  a.reduce((sum, value, i) => sum + value * b[i]!, 0);
export const length = (a: Vector): number => Math.hypot(...a);
export const distance = (a: Vector, b: Vector): number => length(minus(a, b));
export const cross = ([a, b, c]: Vector, [x, y, z]: Vector): Vector => [
  b! * z! - c! * y!,
  c! * x! - a! * z!,
  a! * y! - b! * x!,
];
