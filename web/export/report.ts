import { extentsOf } from '../model/bounds.js';
import type { FlapCounts, JobOptions, JobResult, Notice, Piece, Repair } from '../model/job.js';
import { phraseOf, repairPhrase } from '../words/phrase.js';
import type { StageSeconds } from '../model/stage-seconds.js';

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
  efficiency: number;
  flaps: FlapCounts;
  ids: { printed: number; skipped: string[] };
  notices: (Notice & Told)[];
  seconds: StageSeconds;
  search: { generations: number; moves: number };
  result_hash: string;
}

function pieceReport(piece: Piece): PieceReport {
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
  };
}

/** The report of a run. */
export function makeReport(input: ReportInput): Report {
  const { job, result } = input;
  const { model } = result;
  return {
    version: input.version,
    seed: job.seed,
    options: input.options,
    files: input.files,
    model: {
      faces: model.faces.length / 3,
      vertices: model.vertices.length / 3,
      components: model.components,
      repairs: result.repairs.map((repair) => ({ ...repair, text: repairPhrase(repair) })),
      simplified_deviation_mm: result.deviation,
    },
    parts_requested: job.parts === 0 ? 'auto' : job.parts,
    parts: result.parts,
    pieces: result.pieces.map(pieceReport),
    segmentation: Array.from(result.segmentation, (part) => (part === -1 ? -1 : part + 1)),
    size_mm: [...extentsOf(model.vertices)],
    sheets: result.sheets.length,
    efficiency: result.efficiency,
    flaps: result.flaps,
    ids: { printed: result.ids.printed, skipped: result.ids.skipped },
    notices: [...result.notices, ...input.printed].map((notice) => ({
      ...notice,
      text: phraseOf(notice),
    })),
    seconds: input.seconds,
    search: result.search,
    result_hash: result.hash,
  };
}
