/** Whether a model can be built as it is laid out, and what stands against it, for programs. */
import type { JobResult, Notice } from './job.js';
import { namelessPieces } from './left-out.js';
import type { MessageParams } from './message.js';
import { tinyPieces } from './print-advice.js';
import { overlappingPieces } from './result-notices.js';
import { measureSeams } from './seam-measures.js';
import { goodSeam, medianSeam } from './short-seams.js';

/** green: nothing stands against it; amber: it takes patience or skill; red: it cannot be built so. */
export type Level = 'green' | 'amber' | 'red';

export interface Finding {
  code: string;
  level: Level;
  /** How many seams, pieces or faces it is about. */
  count: number;
  params: MessageParams;
}

/** Where half of the seams are shorter, no fingers hold them; mm. */
const hopelessSeam = 4;

/** Shares of the length of all seams without a flap: tape does for some, but not for most. */
const manyMissing = 0.1;
const mostMissing = 0.5;

/** So many of the seams without a number can be guessed from their neighbours. */
const manyUnnumbered = 0.1;

function levelOf(value: number, amber: number, red: number): Level {
  if (value > red) return 'red';
  return value > amber ? 'amber' : 'green';
}

/** Pieces of which something is wrong. */
function ofPieces(code: string, level: Level, pieces: string[]): Finding {
  return {
    code,
    level: pieces.length > 0 ? level : 'green',
    count: pieces.length,
    params: { pieces },
  };
}

/** Faces that a person wants no paper for. */
function leftOutFaces(notices: readonly Notice[]): number {
  const faces = notices.find(({ code }) => code === 'small-bodies')?.params['faces'];
  return typeof faces === 'number' ? faces : 0;
}

function unfinished({ model, notices, pieces }: JobResult): Finding {
  const laid = pieces.reduce((sum, { sources }) => sum + sources.length, 0);
  const count = model.faces.length / 3 - laid - leftOutFaces(notices);
  return { code: 'unfinished', level: count > 0 ? 'red' : 'green', count, params: {} };
}

function shortSeams(result: JobResult): Finding {
  const middle = medianSeam(result) ?? goodSeam;
  const count = measureSeams(result).filter(({ length }) => length < goodSeam).length;
  const level = levelOf(-middle, -goodSeam, -hopelessSeam);
  return { code: 'short-seams', level, count, params: { median_mm: middle } };
}

function missingFlaps({ flaps: { missing, missing_mm, wanted_mm } }: JobResult): Finding {
  const share = wanted_mm > 0 ? missing_mm / wanted_mm : 0;
  const count = missing.narrow + missing.thin + missing.blocked + missing.short;
  const level = levelOf(share, manyMissing, mostMissing);
  return { code: 'missing-flaps', level, count, params: { share } };
}

function missingNumbers({ ids: { printed, skipped } }: JobResult): Finding {
  const share = skipped.length / Math.max(1, printed + skipped.length);
  const level = levelOf(share, manyUnnumbered, 1);
  return { code: 'missing-numbers', level, count: skipped.length, params: { share } };
}

function unprovedFolding({ pieces }: JobResult): Finding {
  const names = pieces.filter(({ motion }) => !motion).map(({ name }) => name);
  return ofPieces('unproved-folding', 'amber', names);
}

function conclusion(against: readonly Finding[]): Finding {
  const count = against.length;
  if (against.some(({ level }) => level === 'red')) {
    return { code: 'not-buildable', level: 'red', count, params: {} };
  }
  return count > 0
    ? { code: 'hard', level: 'amber', count, params: {} }
    : { code: 'buildable', level: 'green', count, params: {} };
}

/** The conclusion, `buildable`, `hard` or `not-buildable`, and then what stands against building it, red first. */
export function verdictOf(result: JobResult): Finding[] {
  const findings = [
    unfinished(result),
    ofPieces('overlapping-pieces', 'red', overlappingPieces(result)),
    shortSeams(result),
    missingFlaps(result),
    missingNumbers(result),
    ofPieces('missing-names', 'amber', namelessPieces(result)),
    ofPieces('tiny-pieces', 'amber', tinyPieces(result)),
    unprovedFolding(result),
  ];
  const red = findings.filter(({ level }) => level === 'red');
  const amber = findings.filter(({ level }) => level === 'amber');
  return [conclusion([...red, ...amber]), ...red, ...amber];
}
