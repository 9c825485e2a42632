import type { TimedResult } from '../core/client.js';
import type { JobResult, Notice } from '../model/job.js';
import type { PaperSize } from '../model/paper.js';
import { paperUse } from '../model/paper-use.js';
import { conclusionOf, findingsOn, type Conclusion } from '../model/verdict.js';
import { measureSeams } from '../model/seam-measures.js';
import { count } from '../words/numbers.js';
import { phraseOf, repairPhrase } from '../words/phrase.js';
import { finishedSize } from '../words/summary.js';
import { headline } from '../words/verdict.js';
import { sentence } from './sentence.js';

/** A label and its value. */
export type Fact = [label: string, value: string];

/** How many parts have all their faces in pieces: all of them, unless the run was cancelled. */
export function finishedParts({ labels, pieces, parts }: JobResult): number {
  const missing = new Array<number>(parts).fill(0);
  for (const part of labels) missing[part]! += 1;
  for (const { part, sources } of pieces) missing[part]! -= sources.length;
  return missing.filter((faces) => faces === 0).length;
}

/** The result in one sentence. */
export function leadSentence(result: JobResult, paper: PaperSize): string {
  const finished = finishedParts(result);
  const parts = count(result.parts, 'part');
  const pieces = count(result.pieces.length, 'piece');
  const sheets = `${count(result.sheets.length, 'sheet')} of ${paper.name}`;
  if (finished < result.parts) {
    return `${finished} of ${parts} had their nets when the run was cancelled: ${pieces} on ${sheets}.`;
  }
  if (result.pieces.length === 1) return `All in one piece, on ${sheets}.`;
  if (result.pieces.length === result.parts) return `${parts}, each in one piece, on ${sheets}.`;
  return `${parts} in ${pieces} on ${sheets}.`;
}

/** Whether nobody can build a result, other than because it is only a part of one. */
export function isHopeless(result: JobResult, { level }: Conclusion): boolean {
  return level === 'red' && finishedParts(result) === result.parts;
}

/** That a result cannot be built, in one sentence; null if it can be; `margin`: around each sheet, mm. */
export function hopeless(result: JobResult, margin: number): string | null {
  const findings = findingsOn(result, margin);
  const conclusion = conclusionOf(findings);
  return isHopeless(result, conclusion) ? sentence(headline(conclusion, findings.length)) : null;
}

/** Seconds as people say them: 0.4 s, 12 s, 2 min 5 s. */
function duration(seconds: number): string {
  if (seconds < 10) return `${seconds.toFixed(1)} s`;
  if (seconds < 60) return `${Math.round(seconds)} s`;
  return `${Math.floor(seconds / 60)} min ${Math.floor(seconds % 60)} s`;
}

/** Width and height of the piece with the smallest box, and its letter. */
function smallestPiece({ pieces }: JobResult): string {
  const [smallest] = [...pieces].sort((a, b) => a.width * a.height - b.width * b.height);
  const { name, width, height } = smallest!;
  return `${name}, ${Math.round(width)} × ${Math.round(height)} mm`;
}

/** How many seams have a flap, and what joins the others. */
function flapWords({ flaps: { wanted, full, shrunk, strips, taped } }: JobResult): string {
  const words: string[] = [];
  if (wanted > 0) words.push(`on ${full + shrunk} of ${count(wanted, 'seam')}`);
  if (shrunk > 0) words.push(`${shrunk} of them narrow`);
  if (strips > 0) words.push(count(strips, 'loose strip'));
  if (taped > 0) words.push(`${taped} to be taped`);
  return words.length > 0 ? words.join(', ') : 'none';
}

/** How many seams have their number at both sides. */
function idWords({ ids: { printed, skipped } }: JobResult): string {
  const all = printed + skipped.length;
  return all === 0 ? 'none' : `on ${printed} of ${count(all, 'seam')}`;
}

/** How much there is to glue. */
function glueWords(result: JobResult): string {
  const seams = measureSeams(result);
  const mm = seams.reduce((sum, { length }) => sum + length, 0);
  return seams.length > 0
    ? `${(mm / 1000).toFixed(1)} m on ${count(seams.length, 'seam')}`
    : 'none';
}

/** The figures worth knowing before printing; `margin`: around each sheet, mm. */
export function resultFacts(result: TimedResult, margin: number): Fact[] {
  return [
    ['Finished size', finishedSize(result.model, '×')],
    ['Smallest piece', smallestPiece(result)],
    ['To glue', glueWords(result)],
    ['Flaps', flapWords(result)],
    ['Edge numbers', idWords(result)],
    ['Scale', `1 unit is ${Number(result.scale.toPrecision(3))} mm`],
    ['Paper used', `${Math.round(100 * paperUse(result, margin))} %`],
    ['Triangles', String(result.model.faces.length / 3)],
    ['Computed in', duration(result.seconds.total)],
  ];
}

/** What was changed on the model before it was unfolded. */
export function repairRemarks({ repairs }: JobResult): string[] {
  return repairs.map((repair) => sentence(repairPhrase(repair)));
}

/** Notices as sentences. */
export function noticeRemarks(notices: readonly Notice[]): string[] {
  return notices.map((notice) => sentence(phraseOf(notice)));
}
