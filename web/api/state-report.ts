/** What a state of a document comes to, as the command line reports it in English. */
import { version } from '../../package.json';
import { makeReport, type Report } from '../export/report.js';
import { echo } from '../model/options.js';
import { english } from '../words/en/index.js';
import { jobOf, type DocumentState } from './document-state.js';

export function stateReport({ wishes, result }: DocumentState): Report {
  const options = Object.fromEntries(
    Object.entries(echo(wishes.settings)).filter(([name]) => name !== 'workers'),
  );
  return makeReport({
    version,
    options,
    job: jobOf(wishes),
    files: [],
    result,
    printed: [],
    seconds: result.seconds,
    words: english,
  });
}
