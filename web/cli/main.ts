import { resolve } from 'node:path';
import { version } from '../../package.json';
import { jobOf } from '../api/document-state.js';
import { open } from '../api/node.js';
import type { Session } from '../api/session.js';
import type { TimedResult } from '../core/client.js';
import { JobError } from '../core/job-error.js';
import { nodePool } from '../core/node-pool.js';
import type { TimedEvent } from '../core/protocol.js';
import type { Print } from '../export/print.js';
import { makeReport } from '../export/report.js';
import { reportText } from '../export/report-text.js';
import type { JobOptions } from '../model/job-options.js';
import type { DocumentEdit } from '../model/document-edits.js';
import type { ModelFiles } from '../model/model-files.js';
import { parseCommandLine, type Commands } from './command-line.js';
import { Exit, exitStatus, usageError } from './exit.js';
import { checkFormat, renderOutputs } from './formats.js';
import { exitOf } from './job-failure.js';
import { echo } from '../model/options.js';
import { resultNotices } from '../model/result-notices.js';
import { phraseOf, repairPhrase } from '../words/phrase.js';
import { summarize } from '../words/summary.js';
import { Progress } from './progress.js';
import { readModelFiles } from './read-model-files.js';
import { checkWritable, writeFiles, type OutputFile } from './write-files.js';

/** Everything about the outputs that can be wrong before the work has begun. */
function checkOutputs({ model, outputs, report, settings }: Commands): void {
  for (const path of outputs) checkFormat(path, settings);
  const paths = report === null ? outputs : [...outputs, report];
  const taken = new Set([resolve(model)]);
  for (const path of paths) {
    if (taken.has(resolve(path))) throw usageError(`'${path}' is named twice`);
    taken.add(resolve(path));
  }
  paths.forEach(checkWritable);
}

/** Which of several steps it is. */
function placeOf(step: readonly DocumentEdit[], index: number, count: number): string {
  const [first] = step;
  if (first?.kind === 'name') return `the name '${first.text}': `;
  return count > 1 ? `edit ${index + 1}: ` : '';
}

/** Makes the edits that were asked for, in their order; refused ones end the program. */
async function edit(session: Session, { edits }: Commands): Promise<void> {
  for (const [index, step] of edits.entries()) {
    const made = await session.apply(step);
    if (made.ok) continue;
    throw usageError(`${placeOf(step, index, edits.length)}${made.params.text}`);
  }
}

/** What the command line's files are made of. */
interface Outcome {
  /** What the engine was asked for in the end. */
  job: JobOptions;
  result: TimedResult;
  print: Print;
}

/** Runs the job in workers, so that this thread hears signals at once. */
async function runEngine(
  commands: Commands,
  files: ModelFiles,
  progress: Progress | null,
): Promise<Outcome> {
  const { edits, model, settings } = commands;
  const pool = nodePool(settings.workers === 'auto' ? undefined : settings.workers);
  const session = await open(files, { pool });
  const onEvent = (event: TimedEvent): void => progress?.onEvent(event);
  // Nobody needs to know what is wrong with a result that is still to be changed.
  const onWorkEvent = (event: TimedEvent): void => {
    if (event.type !== 'notice') onEvent(event);
  };
  try {
    await session.runWith(settings, { onEvent: edits.length === 0 ? onEvent : onWorkEvent });
    await edit(session, commands);
    const { result, wishes } = await session.state();
    return { job: jobOf(wishes), result, print: await session.print() };
  } catch (error) {
    throw error instanceof JobError ? exitOf(model, error) : error;
  } finally {
    progress?.clear();
    pool.close();
  }
}

function renderReport(
  { editWords, report, settings }: Commands,
  written: OutputFile[],
  { job, result, print }: Outcome,
): OutputFile[] {
  if (report === null) return [];
  const content = makeReport({
    version,
    options: { ...echo(settings), ...editWords },
    job,
    files: [...written.map(({ path }) => path), report],
    result,
    printed: print.notices,
    seconds: result.seconds,
  });
  return [{ path: report, content: reportText(content) }];
}

/** Everything that was done to the model, and what to know before it is printed. */
function remarks({ job, result, print }: Outcome): string[] {
  const notices = resultNotices(result, job.margin, print.notices);
  return [...result.repairs.map(repairPhrase), ...notices.map(phraseOf)];
}

async function run(args: string[]): Promise<void> {
  const commands = parseCommandLine(args);
  checkOutputs(commands);
  const progress = commands.quiet ? null : new Progress(process.stderr);
  commands.idle.forEach((text) => progress?.note(text));
  const model = readModelFiles(commands.model);
  const outcome = await runEngine(commands, model, progress);
  const { result, print } = outcome;
  const files = await renderOutputs(commands.outputs, result, print);
  files.push(...renderReport(commands, files, outcome));
  remarks(outcome).forEach((text) => progress?.note(text));
  writeFiles(files);
  progress?.conclude(summarize(commands.model, result));
}

function fail(error: unknown): void {
  const known = error instanceof Exit;
  const message = error instanceof Error ? error.message : String(error);
  const line = known ? message : `foldwright: internal error: ${message.replace(/\s+/g, ' ')}`;
  if (line !== '') console.error(line);
  process.exitCode = known ? error.status : exitStatus.internal;
}

/** A model in, nets on paper and a report out; sets the exit status and never rejects. */
export async function main(args: string[]): Promise<void> {
  try {
    await run(args);
  } catch (error) {
    fail(error);
  }
}
