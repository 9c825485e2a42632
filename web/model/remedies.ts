/** What helps against what a verdict finds, as far as one click can do it. */
import { defaultOptions } from './default-options.js';
import type { DocumentEdit } from './document-edits.js';
import type { JobResult, Piece } from './job.js';
import type { Settings } from './options.js';
import { partNeighbours } from './part-neighbours.js';
import { smallerNotice, type Smaller } from './print-advice.js';
import { fewerFaces, largerSize, longerSeams, type Size } from './short-seams.js';
import { hopelessSeam, manyHours, type Finding } from './verdict.js';

/** Names are those of pieces. */
export type Remedy =
  /** Another finished size, in mm; `saves`: how many sheets fewer that takes. */
  | { kind: 'size'; side: Smaller['what']; mm: number; saves: number }
  | { kind: 'sheets'; sheets: number }
  /** So many triangles, which take a new search. */
  | { kind: 'faces'; faces: number }
  /** The whole search once more, to its end. */
  | { kind: 'finish' }
  | { kind: 'strips' }
  | { kind: 'numbers-on-flaps' }
  /** Other nets for parts, which count from 1. */
  | { kind: 'again'; parts: number[]; names: string[]; seed: number }
  /** One part out of two. */
  | { kind: 'merge'; parts: [number, number]; names: [string, string] };

/** A result, and what was asked for. */
export interface Looked {
  result: JobResult;
  settings: Settings;
}

/** So much longer than those that are hopeless: sizes are rounded, and nets differ a bit. */
const bearable = 1.1;

/** The engine tells of narrower places where much hangs at both sides; mm. */
const goodNeck = 5;

/** A seed that is the same for the same result, and another one for each other. */
function nextSeed({ hash }: JobResult): number {
  return parseInt(hash.slice(0, 8), 16);
}

function again(result: JobResult, isBad: (piece: Piece) => boolean): Remedy[] {
  const bad = result.pieces.filter(isBad);
  if (bad.length === 0) return [];
  const parts = [...new Set(bad.map(({ part }) => part + 1))].sort((a, b) => a - b);
  const names = bad.map(({ name }) => name);
  return [{ kind: 'again', parts, names, seed: nextSeed(result) }];
}

function sized(size: Size): Remedy[] {
  return (['height', 'width', 'depth'] as const).flatMap((side): Remedy[] => {
    const mm = size[side];
    return mm === undefined ? [] : [{ kind: 'size', side, mm, saves: 0 }];
  });
}

function longSeams({ result, settings: { margin } }: Looked, isHopeless: boolean): Remedy[] {
  const best = longerSeams(result, margin);
  // What makes no seams good to glue may still make them such that some fingers can.
  const { faces, ...size } =
    isHopeless && Object.keys(best).length === 0
      ? longerSeams(result, margin, bearable * hopelessSeam)
      : best;
  const sizes = sized(size);
  return faces === undefined ? sizes : [...sizes, { kind: 'faces', faces }];
}

/** A size at which the narrowest place is wide enough, or other nets, which may have none so narrow. */
function widerNecks({ result, settings: { margin } }: Looked): Remedy[] {
  const narrowest = Math.min(...result.pieces.flatMap(({ necks }) => [...necks]));
  const wider = sized(largerSize(result, goodNeck / narrowest, margin));
  return [...wider, ...again(result, ({ necks }) => necks.length > 0)];
}

/** Joins the first of these pieces that is a whole part to the smallest piece beside it that is one, too. */
function joined(result: JobResult, names: readonly string[]): Remedy[] {
  const neighbours = partNeighbours(result);
  const { pieces } = result;
  const wholes = pieces.filter(
    ({ part }, i) => !pieces.some((one, k) => k !== i && one.part === part),
  );
  for (const { name, part } of wholes.filter((whole) => names.includes(whole.name))) {
    const beside = wholes.filter((whole) => neighbours[part]!.has(whole.part));
    const [least] = beside.sort((a, b) => a.sources.length - b.sources.length);
    if (!least) continue;
    return [{ kind: 'merge', parts: [part + 1, least.part + 1], names: [name, least.name] }];
  }
  return [];
}

function fewerSheets({ result }: Looked): Remedy[] {
  const smaller = smallerNotice(result);
  const { length: sheets } = result.sheets;
  if (smaller) {
    const { what: side, size_mm: mm } = smaller;
    return [{ kind: 'size', side, mm, saves: sheets - smaller.sheets }];
  }
  return sheets > 1 ? [{ kind: 'sheets', sheets: sheets - 1 }] : [];
}

/** What can be done about a finding with one click, the best first; nothing about one that is green. */
export function remediesFor(finding: Finding, looked: Looked): Remedy[] {
  if (finding.level === 'green') return [];
  const { result, settings } = looked;
  switch (finding.code) {
    case 'short-seams':
      return longSeams(looked, finding.level === 'red');
    case 'missing-flaps':
      return settings['glue-strips'] === 'all' ? [] : [{ kind: 'strips' }];
    case 'missing-numbers':
      return settings.ids === defaultOptions.ids ? [] : [{ kind: 'numbers-on-flaps' }];
    case 'tiny-pieces':
      return joined(result, finding.params.pieces);
    case 'overlapping-pieces':
      return again(result, ({ overlaps }) => overlaps > 0);
    case 'weak-necks':
      return widerNecks(looked);
    case 'unproved-folding':
      return again(result, ({ motion, foldable }) => !motion && foldable === 'no');
    case 'spare-sheet':
      return fewerSheets(looked);
    case 'long-building': {
      const share = (manyHours * 3600) / finding.params.seconds;
      const { faces } = fewerFaces(result, share);
      return faces === undefined ? [] : [{ kind: 'faces', faces }];
    }
    case 'unfinished':
    case 'run-stopped':
      return [{ kind: 'finish' }];
    case 'beyond-paper':
    case 'missing-names':
      return [];
  }
}

/** The edits that a remedy is, made in one go; null if it takes a new search of the whole model. */
export function remedyEdits(remedy: Remedy): DocumentEdit[] | null {
  switch (remedy.kind) {
    case 'size':
      return [{ kind: 'paper', options: { [remedy.side]: remedy.mm } }];
    case 'sheets':
      return [{ kind: 'paper', options: { sheets: remedy.sheets } }];
    case 'strips':
      return [{ kind: 'paper', options: { glueStrips: 'all' } }];
    case 'numbers-on-flaps':
      return [{ kind: 'paper', options: { ids: defaultOptions.ids } }];
    case 'again':
      return remedy.parts.map((part) => ({ kind: 'again', part, seed: remedy.seed }));
    case 'merge':
      return [{ kind: 'merge', parts: remedy.parts }];
    case 'faces':
    case 'finish':
      return null;
  }
}
