import type { TimedResult } from '../core/client.js';
import type { JobResult, Notice } from '../model/job.js';
import type { PaperSize } from '../model/paper.js';
import { paperUse } from '../model/paper-use.js';
import { conclusionOf, findingsOn, type Conclusion } from '../model/verdict.js';
import { measureSeams } from '../model/seam-measures.js';
import { phraseOf, repairPhrase } from '../words/phrase.js';
import { finishedSize } from '../words/summary.js';
import type { Words } from '../words/words.js';
import { sentence } from './sentence.js';

/** A label and its value. */
export type Fact = [label: string, value: string];

/** How many parts have all their faces in pieces: all of them, unless the run was stopped. */
export function finishedParts({ labels, pieces, parts }: JobResult): number {
  const missing = new Array<number>(parts).fill(0);
  for (const part of labels) missing[part]! += 1;
  for (const { part, sources } of pieces) missing[part]! -= sources.length;
  return missing.filter((faces) => faces === 0).length;
}

/** The result in one sentence, or two where something is missing. */
export function leadSentence(words: Words, result: JobResult, paper: PaperSize): string {
  const { result: told } = words;
  const finished = finishedParts(result);
  const { parts } = result;
  const [pieces, sheets] = [result.pieces.length, result.sheets.length];
  if (finished < parts) {
    return told.withHoles({ finished, parts, pieces, sheets, paper: paper.name });
  }
  if (pieces === 1) return told.onePiece(sheets, paper.name);
  if (pieces === parts) return told.eachInOne(parts, sheets, paper.name);
  return told.inPieces(parts, pieces, sheets, paper.name);
}

/** Whether nobody can build a result, other than because it is only a part of one. */
export function isHopeless(result: JobResult, { level }: Conclusion): boolean {
  return level === 'red' && finishedParts(result) === result.parts;
}

/** That a result cannot be built, in one sentence; null if it can be; `margin`: around each sheet, mm. */
export function hopeless(words: Words, result: JobResult, margin: number): string | null {
  const findings = findingsOn(result, margin);
  const conclusion = conclusionOf(findings);
  if (!isHopeless(result, conclusion)) return null;
  return sentence(words.verdict.headline(conclusion, findings.length));
}

/** Seconds as people say them: 0.4 s, 12 s, 2 min 5 s. */
function duration({ result: told }: Words, seconds: number): string {
  if (seconds < 10) return told.seconds(seconds, 1);
  if (seconds < 60) return told.seconds(Math.round(seconds), 0);
  return told.minutes(Math.floor(seconds / 60), Math.floor(seconds % 60));
}

/** Width and height of the piece with the smallest box, and its letter. */
function smallestPiece({ result: told }: Words, { pieces }: JobResult): string {
  const [smallest] = [...pieces].sort((a, b) => a.width * a.height - b.width * b.height);
  const { name, width, height } = smallest!;
  return told.smallest(name, Math.round(width), Math.round(height));
}

/** How many seams have a flap, and what joins the others. */
function flapWords({ result: told }: Words, { flaps }: JobResult): string {
  const { wanted, full, shrunk, strips, taped } = flaps;
  return told.flaps({ wanted, flaps: full + shrunk, shrunk, strips, taped }) || told.none;
}

/** How many seams have their number at both sides. */
function idWords({ result: told }: Words, { ids: { printed, skipped } }: JobResult): string {
  const all = printed + skipped.length;
  return all === 0 ? told.none : told.numbers(printed, all);
}

/** How much there is to glue. */
function glueWords({ result: told }: Words, result: JobResult): string {
  const seams = measureSeams(result);
  const mm = seams.reduce((sum, { length }) => sum + length, 0);
  return seams.length > 0 ? told.glue(mm / 1000, seams.length) : told.none;
}

/** Figures that one net has better than another; `margin`: around each sheet, mm. */
export function craftFacts(words: Words, result: JobResult, margin: number): Fact[] {
  const { result: told } = words;
  const { facts } = told;
  return [
    [facts.size, finishedSize(words, result.model, '×')],
    [facts.smallest, smallestPiece(words, result)],
    [facts.glue, glueWords(words, result)],
    [facts.flaps, flapWords(words, result)],
    [facts.numbers, idWords(words, result)],
    [facts.scale, told.scale(Number(result.scale.toPrecision(3)))],
    [facts.paper, told.percent(Math.round(100 * paperUse(result, margin)))],
  ];
}

/** The figures worth knowing before printing; `margin`: around each sheet, mm. */
export function resultFacts(words: Words, result: TimedResult, margin: number): Fact[] {
  const { facts } = words.result;
  return [
    ...craftFacts(words, result, margin),
    [facts.triangles, words.speech.figure(result.model.faces.length / 3)],
    [facts.time, duration(words, result.seconds.total)],
  ];
}

/** What was changed on the model before it was unfolded. */
export function repairRemarks(words: Words, { repairs }: JobResult): string[] {
  return repairs.map((repair) => sentence(repairPhrase(words, repair)));
}

/** Notices as sentences. */
export function noticeRemarks(words: Words, notices: readonly Notice[]): string[] {
  return notices.map((notice) => sentence(phraseOf(words, notice)));
}
