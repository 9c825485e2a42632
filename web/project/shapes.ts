/** Checks of what comes from a file and may be anything. */

export type Shape = (value: unknown) => boolean;

export const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

export const text: Shape = (value) => typeof value === 'string';
export const finite: Shape = Number.isFinite;

/** Far more than faces, vertices and parts of anything; the engine counts in 32 bits. */
const most = 2 ** 31 - 1;

/** A whole number, `least` or more. */
export function whole(least = 0): Shape {
  return (value) => Number.isInteger(value) && Number(value) >= least && Number(value) <= most;
}

export function listOf(item: Shape): Shape {
  return (value) => Array.isArray(value) && value.every(item);
}

export function oneOf(...words: readonly string[]): Shape {
  return (value) => words.some((word) => word === value);
}

/** An object whose fields are all alike. */
export function recordOf(item: Shape): Shape {
  return (value) => isRecord(value) && Object.values(value).every(item);
}

export function nullOr(shape: Shape): Shape {
  return (value) => value === null || shape(value);
}

/** An object with these fields; others do no harm. */
export function record(
  fields: Readonly<Record<string, Shape>>,
  may: Readonly<Record<string, Shape>> = {},
): Shape {
  return (value) =>
    isRecord(value) &&
    Object.entries(fields).every(([name, shape]) => shape(value[name])) &&
    Object.entries(may).every(([name, shape]) => value[name] === undefined || shape(value[name]));
}
