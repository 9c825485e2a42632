/** Whether a model can be built as it is laid out, and what stands against it. */
import { creasesOf } from './assembly-steps.js';
import { buildingTime } from './building-time.js';
import type { JobResult, Notice, Piece } from './job.js';
import { namelessPieces } from './left-out.js';
import { median } from './median.js';
import { isSheetSpare, lastSheetFill, smallerNotice, tinyPieces } from './print-advice.js';
import { overlappingPieces } from './result-notices.js';
import { measureSeams } from './seam-measures.js';
import { goodSeam } from './short-seams.js';

/** green: nothing stands against it; amber: it takes patience or skill, or costs paper; red: it cannot be built so. */
export type Level = 'green' | 'amber' | 'red';

type None = Record<never, never>;
type Pieces = { pieces: string[] };

/** What is found, with what its sentence needs; lengths in mm, shares from 0 to 1. */
export interface FindingParams {
  unfinished: None;
  'run-stopped': None;
  'overlapping-pieces': Pieces;
  'beyond-paper': Pieces;
  'short-seams': { median_mm: number };
  'missing-flaps': { share: number };
  'missing-numbers': { share: number };
  'missing-names': Pieces;
  'tiny-pieces': Pieces;
  'weak-necks': Pieces;
  /** `unchecked`: how many of them nobody has looked at; for the others no way was found. */
  'unproved-folding': Pieces & { unchecked: number };
  'spare-sheet': { sheets: number; percent: number };
  'long-building': { seconds: number };
}

export type FindingCode = keyof FindingParams;

interface Counted {
  level: Level;
  /** How many triangles, seams, pieces or sheets it is about; of the time that building takes, hours. */
  count: number;
}

export type Finding = {
  [Code in FindingCode]: Counted & { code: Code; params: FindingParams[Code] };
}[FindingCode];

/** What all findings come to; its count is that of the findings against building it. */
export interface Conclusion extends Counted {
  code: 'buildable' | 'hard' | 'not-buildable';
  params: None;
}

/** Where half of the seams are shorter, no fingers hold them; mm. */
export const hopelessSeam = 4;

/** Shares of the length of all seams without a flap: tape does for some, but not for most. */
const manyMissing = 0.1;
const mostMissing = 0.5;

/** So many of the seams without a number can be guessed from their neighbours. */
const manyUnnumbered = 0.1;

/** A weekend; what takes longer is often left unfinished. */
export const manyHours = 10;

/** mm that rounding may move a piece. */
const samePlace = 0.01;

function levelOf(value: number, amber: number, red: number): Level {
  if (value > red) return 'red';
  return value > amber ? 'amber' : 'green';
}

/** Pieces of which something is wrong. */
function ofPieces<
  Code extends
    'overlapping-pieces' | 'beyond-paper' | 'missing-names' | 'tiny-pieces' | 'weak-necks',
>(code: Code, level: Level, pieces: string[]): Counted & { code: Code; params: Pieces } {
  const { length: count } = pieces;
  return { code, level: count > 0 ? level : 'green', count, params: { pieces } };
}

function namesOf({ pieces }: JobResult, isConcerned: (piece: Piece) => boolean): string[] {
  return pieces.filter(isConcerned).map(({ name }) => name);
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

/** That something is missing tells it already. */
function runStopped({ notices }: JobResult, { level }: Finding): Finding {
  const isStopped = level === 'green' && notices.some(({ code }) => code === 'run-stopped');
  return {
    code: 'run-stopped',
    level: isStopped ? 'amber' : 'green',
    count: Number(isStopped),
    params: {},
  };
}

function beyondPaper(result: JobResult, margin: number): Finding {
  const least = margin - samePlace;
  const sticksOut = ({ x, y, width, height, sheet }: Piece): boolean => {
    const paper = result.sheets[sheet]!;
    const [right, top] = [paper.width - x - width, paper.height - y - height];
    return Math.min(x, y, right, top) < least;
  };
  return ofPieces('beyond-paper', 'red', namesOf(result, sticksOut));
}

function shortSeams(result: JobResult): Finding {
  const lengths = measureSeams(result).map(({ length }) => length);
  const middle = lengths.length > 0 ? median(lengths) : goodSeam;
  const count = lengths.filter((length) => length < goodSeam).length;
  const level = levelOf(-middle, -goodSeam, -hopelessSeam);
  return { code: 'short-seams', level, count, params: { median_mm: middle } };
}

/** A loose strip of paper does what a flap does. */
function missingFlaps(result: JobResult): Finding {
  const { missing, missing_mm, wanted_mm, strips } = result.flaps;
  const joined = new Set(result.strips.map(({ id }) => id));
  const stripped = joined.size > 0 ? measureSeams(result) : [];
  const bare = stripped.reduce(
    (rest, { seam, length }) => (joined.has(seam.name) ? rest - length : rest),
    missing_mm,
  );
  const all = missing.narrow + missing.thin + missing.blocked + missing.short;
  const count = Math.max(0, all - strips);
  const share = count > 0 && wanted_mm > 0 ? Math.max(0, bare) / wanted_mm : 0;
  const level = levelOf(share, manyMissing, mostMissing);
  return { code: 'missing-flaps', level, count, params: { share } };
}

function missingNumbers({ ids: { printed, skipped } }: JobResult): Finding {
  const share = skipped.length / Math.max(1, printed + skipped.length);
  const level = levelOf(share, manyUnnumbered, 1);
  return { code: 'missing-numbers', level, count: skipped.length, params: { share } };
}

function unprovedFolding(result: JobResult): Finding {
  const unproved = result.pieces.filter(({ motion }) => !motion);
  const unchecked = unproved.filter(({ foldable }) => foldable === 'unchecked').length;
  const { length: count } = unproved;
  const params = { pieces: unproved.map(({ name }) => name), unchecked };
  return { code: 'unproved-folding', level: count > 0 ? 'amber' : 'green', count, params };
}

function spareSheet(result: JobResult, margin: number): Finding {
  const isSpare = isSheetSpare(result, margin) || smallerNotice(result) !== null;
  const percent = Math.round(100 * lastSheetFill(result, margin));
  const params = { sheets: result.sheets.length, percent };
  return {
    code: 'spare-sheet',
    level: isSpare ? 'amber' : 'green',
    count: Number(isSpare),
    params,
  };
}

/** Seconds that it takes to build a result whose seams are glued. */
export function buildingSeconds(result: JobResult): number {
  const creases = result.pieces.map((piece) => creasesOf(piece));
  return buildingTime(result, creases).glued;
}

function longBuilding(result: JobResult): Finding {
  const seconds = buildingSeconds(result);
  const hours = seconds / 3600;
  const level = levelOf(hours, manyHours, Infinity);
  return { code: 'long-building', level, count: Math.round(hours), params: { seconds } };
}

const order: readonly Level[] = ['red', 'amber', 'green'];

/**
 * All that a result is looked at for, red before amber before green; among equals what matters most comes first.
 *
 * @param margin around each sheet, mm
 */
export function findingsOn(result: JobResult, margin: number): Finding[] {
  const missing = unfinished(result);
  const findings: Finding[] = [
    missing,
    runStopped(result, missing),
    ofPieces('overlapping-pieces', 'red', overlappingPieces(result)),
    beyondPaper(result, margin),
    shortSeams(result),
    missingFlaps(result),
    missingNumbers(result),
    ofPieces('missing-names', 'amber', namelessPieces(result)),
    ofPieces('tiny-pieces', 'amber', tinyPieces(result)),
    ofPieces(
      'weak-necks',
      'amber',
      namesOf(result, ({ necks }) => necks.length > 0),
    ),
    unprovedFolding(result),
    longBuilding(result),
    spareSheet(result, margin),
  ];
  return order.flatMap((level) => findings.filter((finding) => finding.level === level));
}

/** What findings come to. A sheet that could be saved costs paper, but stands against nothing. */
export function conclusionOf(findings: readonly Finding[]): Conclusion {
  const against = findings.filter(({ code, level }) => level !== 'green' && code !== 'spare-sheet');
  const count = against.length;
  if (against.some(({ level }) => level === 'red')) {
    return { code: 'not-buildable', level: 'red', count, params: {} };
  }
  return count > 0
    ? { code: 'hard', level: 'amber', count, params: {} }
    : { code: 'buildable', level: 'green', count, params: {} };
}

/** The conclusion, and then what stands against building it, red first; `margin`: around each sheet, mm. */
export function verdictOf(result: JobResult, margin: number): (Conclusion | Finding)[] {
  const findings = findingsOn(result, margin);
  return [conclusionOf(findings), ...findings.filter(({ level }) => level !== 'green')];
}
