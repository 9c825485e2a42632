/** One model through the command line, with everything that it writes examined. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { foldwright, inFolder, type Ended } from './command.js';
import { checkFold } from './fold-check.js';
import { parseFold } from './fold-file.js';
import { schemaErrors } from './report-schema.js';

interface ReadReport {
  model: { faces: number };
  parts: number;
  pieces: object[];
  sheets: number;
  seconds: { total: number };
}

export interface CheckedRun {
  ended: Ended;
  /** Null unless the run succeeded. */
  report: ReadReport | null;
  /** Everything that is wrong with the files written. */
  violations: string[];
}

export function checkedRun(model: string, args: string[]): Promise<CheckedRun> {
  return inFolder(async (folder) => {
    const [fold, path] = [join(folder, 'out.fold'), join(folder, 'report.json')];
    const all = [model, '-o', fold, '--report', path, '--quiet', ...args];
    const ended = await foldwright(all);
    if (ended.status !== 0) return { ended, report: null, violations: [] };
    const report = JSON.parse(readFileSync(path, 'utf8')) as ReadReport;
    const violations = [
      ...checkFold(parseFold(readFileSync(fold, 'utf8'))),
      ...schemaErrors(report),
    ];
    return { ended, report, violations };
  });
}
