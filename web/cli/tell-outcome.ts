/** What is told of an outcome: its report, and what to know before it is printed. */
import { version } from '../../package.json';
import { makeReport, type Report } from '../export/report.js';
import { reportText } from '../export/report-text.js';
import { echo } from '../model/options.js';
import { resultNotices } from '../model/result-notices.js';
import { phraseOf, repairPhrase } from '../words/phrase.js';
import type { Words } from '../words/words.js';
import type { EditWords } from './command-line.js';
import type { Outcome } from './engine-run.js';

/** @param files all that are written, the report among them */
export function reportFor(
  { job, result, print, settings }: Outcome,
  words: Words,
  files: string[],
  editWords?: EditWords,
): Report {
  return makeReport({
    version,
    options: { ...echo(settings), ...editWords },
    job,
    files,
    result,
    printed: print.notices,
    seconds: result.seconds,
    words,
  });
}

/** The same as JSON. */
export function reportOn(
  outcome: Outcome,
  words: Words,
  files: string[],
  editWords: EditWords,
): string {
  return reportText(reportFor(outcome, words, files, editWords));
}

/** Everything that was done to the model, and what to know before it is printed. */
export function remarks({ job, result, print }: Outcome, words: Words): string[] {
  const notices = resultNotices(result, job.margin, print.notices);
  return [
    ...result.repairs.map((repair) => repairPhrase(words, repair)),
    ...notices.map((notice) => phraseOf(words, notice)),
  ];
}
