/** A report as JSON: a field on a line, and every list of numbers on one, as that of all faces would fill pages. */
import type { Report } from './report.js';

type Entry = readonly [start: string, value: unknown];

function block(open: string, close: string, entries: readonly Entry[], indent: string): string {
  if (entries.length === 0) return open + close;
  const inner = `${indent}  `;
  const lines = entries.map(([start, value]) => `${inner}${start}${textOf(value, inner)}`);
  return `${open}\n${lines.join(',\n')}\n${indent}${close}`;
}

function textOf(value: unknown, indent: string): string {
  if (Array.isArray(value)) {
    const isFlat = value.every((item) => typeof item === 'number');
    const entries = value.map((item): Entry => ['', item]);
    return isFlat ? JSON.stringify(value) : block('[', ']', entries, indent);
  }
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const given = Object.entries(value).filter(([, field]) => field !== undefined);
  const entries = given.map(([name, field]): Entry => [`${JSON.stringify(name)}: `, field]);
  return block('{', '}', entries, indent);
}

/** What the command line writes with `--report`; reports of a batch tell no times. */
export function reportText(report: Omit<Report, 'seconds'>): string {
  return `${textOf(report, '')}\n`;
}
