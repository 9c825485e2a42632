import { extentsOf } from '../model/bounds.js';
import type { FlapCounts, JobResult, Notice, Piece, Repair } from '../model/job.js';
import type { JobOptions } from '../model/job-options.js';
import { median } from '../model/median.js';
import { paperUse } from '../model/paper-use.js';
import { resultNotices } from '../model/result-notices.js';
import { glueOf, measureSeams, shrunkHeights, type MeasuredSeam } from '../model/seam-measures.js';
import type { StageSeconds } from '../model/stage-seconds.js';
import { verdictOf, type Conclusion, type Finding } from '../model/verdict.js';
import { phraseOf, repairPhrase } from '../words/phrase.js';
import type { Words } from '../words/words.js';

/** What a report is made of. */
export interface ReportInput {
  /** Version of the package. */
  version: string;
  /** The options as a person would write them, by name. */
  options: Record<string, unknown>;
  job: JobOptions;
  /** Every file written, as named by the user. */
  files: string[];
  result: JobResult;
  /** Notices that came up when the sheets were drawn. */
  printed: Notice[];
  seconds: StageSeconds;
  /** For its texts. */
  words: Words;
}

/** Pieces, parts and sheets count from 1, as a person sees them. */
export interface PieceReport {
  id: number;
  name: string;
  part: number;
  sheet: number;
  faces: number;
  cause: Piece['cause'];
  overlaps: number;
  width_mm: number;
  height_mm: number;
  foldable: Piece['foldable'];
  certified: boolean;
  /** Lengths of folds that are too short for what hangs at them. */
  necks_mm: number[];
  /** Length of the seams that close it, and of those that join it to other pieces. */
  glue_within_mm: number;
  glue_between_mm: number;
}

/** Of the flaps that are lower than wished for; null if there are none. */
export interface ShrunkReport {
  least: number;
  median: number;
}

/** A message with its words. */
interface Told {
  text: string;
}

/** What a run did, for programs; `report.schema.json` describes it field by field. */
export interface Report {
  version: string;
  seed: number;
  options: Record<string, unknown>;
  files: string[];
  model: {
    faces: number;
    vertices: number;
    components: number;
    repairs: (Repair & Told)[];
    simplified_deviation_mm: number;
  };
  parts_requested: number | 'auto';
  parts: number;
  pieces: PieceReport[];
  /** Per face of the file as read: its part, counted from 1; -1 if it was dropped. */
  segmentation: number[];
  size_mm: number[];
  sheets: number;
  /** Paper inside cut lines over printable area. */
  efficiency: number;
  /** Length of all seams. */
  glue_mm: number;
  seams: number;
  /** Of these, how many close a piece, and how many join two. */
  seams_within: number;
  seams_between: number;
  flaps: FlapCounts & { shrunk_mm: ShrunkReport | null };
  ids: { printed: number; skipped: string[] };
  notices: (Notice & Told)[];
  /** Whether the model can be built as laid out, and what stands against it. */
  verdict: (Conclusion | Finding)[];
  seconds: StageSeconds;
  search: { generations: number; moves: number };
  result_hash: string;
}

/** A sum of lengths, to a thousandth of a mm as they are drawn. */
function drawn(mm: number): number {
  return Number(mm.toFixed(3));
}

function pieceReport(piece: Piece, index: number, seams: readonly MeasuredSeam[]): PieceReport {
  const { within, between } = glueOf(seams.filter(({ seam }) => seam.pieces.includes(index)));
  return {
    id: piece.id + 1,
    name: piece.name,
    part: piece.part + 1,
    sheet: piece.sheet + 1,
    faces: piece.sources.length,
    cause: piece.cause,
    overlaps: piece.overlaps,
    width_mm: piece.width,
    height_mm: piece.height,
    foldable: piece.foldable,
    certified: piece.motion !== undefined,
    necks_mm: Array.from(piece.necks),
    glue_within_mm: drawn(within.mm),
    glue_between_mm: drawn(between.mm),
  };
}

function shrunkReport(result: JobResult): ShrunkReport | null {
  const heights = shrunkHeights(result);
  return heights.length > 0 ? { least: drawn(heights[0]!), median: drawn(median(heights)) } : null;
}

/** The report of a run. */
export function makeReport(input: ReportInput): Report {
  const { job, result, words } = input;
  const { model } = result;
  const seams = measureSeams(result);
  const { within, between } = glueOf(seams);
  return {
    version: input.version,
    seed: job.seed,
    options: input.options,
    files: input.files,
    model: {
      faces: model.faces.length / 3,
      vertices: model.vertices.length / 3,
      components: model.components,
      repairs: result.repairs.map((repair) => ({ ...repair, text: repairPhrase(words, repair) })),
      simplified_deviation_mm: result.deviation,
    },
    parts_requested: job.parts === 0 ? 'auto' : job.parts,
    parts: result.parts,
    pieces: result.pieces.map((piece, index) => pieceReport(piece, index, seams)),
    segmentation: Array.from(result.segmentation, (part) => (part === -1 ? -1 : part + 1)),
    size_mm: [...extentsOf(model.vertices)],
    sheets: result.sheets.length,
    efficiency: paperUse(result, job.margin),
    glue_mm: drawn(within.mm + between.mm),
    seams: seams.length,
    seams_within: within.seams,
    seams_between: between.seams,
    flaps: { ...result.flaps, shrunk_mm: shrunkReport(result) },
    ids: { printed: result.ids.printed, skipped: result.ids.skipped },
    notices: resultNotices(result, job.margin, input.printed).map((notice) => ({
      ...notice,
      text: phraseOf(words, notice),
    })),
    verdict: verdictOf(result, job.margin),
    seconds: input.seconds,
    search: result.search,
    result_hash: result.hash,
  };
}
