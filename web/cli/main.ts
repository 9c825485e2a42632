import { resolve } from 'node:path';
import { JobError } from '../core/job-error.js';
import { nodePool } from '../core/node-pool.js';
import type { ModelFiles } from '../model/model-files.js';
import { loadWords } from '../words/load.js';
import { summarize } from '../words/summary.js';
import type { Words } from '../words/words.js';
import { parseCommandLine, type Commands } from './command-line.js';
import { unfoldModel, type Outcome } from './engine-run.js';
import { Exit, exitStatus, usageError } from './exit.js';
import { checkFormat, renderOutputs } from './formats.js';
import { exitOf } from './job-failure.js';
import { Progress } from './progress.js';
import { wantedLanguage } from './wanted-language.js';
import { readModelFiles } from './read-model-files.js';
import { remarks, reportOn } from './tell-outcome.js';
import { checkWritable, writeFiles } from './write-files.js';

/** Everything about the outputs that can be wrong before the work has begun. */
function checkOutputs({ model, outputs, report, settings }: Commands): void {
  for (const path of outputs) checkFormat(path, settings);
  const paths = report === null ? outputs : [...outputs, report];
  const taken = new Set([resolve(model)]);
  for (const path of paths) {
    if (taken.has(resolve(path))) throw usageError(({ command }) => command.namedTwice(path));
    taken.add(resolve(path));
  }
  paths.forEach(checkWritable);
}

/** Runs the job in workers, so that this thread hears signals at once. */
async function runEngine(
  commands: Commands,
  words: Words,
  files: ModelFiles,
  progress: Progress | null,
): Promise<Outcome> {
  const { workers } = commands.settings;
  const pool = nodePool(workers === 'auto' ? undefined : workers);
  try {
    return await unfoldModel(commands, files, { pool, listener: progress, words });
  } catch (error) {
    throw error instanceof JobError ? exitOf(commands.model, error) : error;
  } finally {
    progress?.clear();
    pool.close();
  }
}

async function runOne(args: string[], words: Words): Promise<void> {
  const commands = parseCommandLine(args, words);
  checkOutputs(commands);
  const progress = commands.quiet ? null : new Progress(process.stderr, words);
  const model = readModelFiles(commands.model);
  const outcome = await runEngine(commands, words, model, progress);
  const { result } = outcome;
  const files = await renderOutputs(commands.outputs, outcome);
  const { report } = commands;
  if (report !== null) {
    const names = [...files.map(({ path }) => path), report];
    files.push({ path: report, content: reportOn(outcome, words, names, commands.editWords) });
  }
  remarks(outcome, words).forEach((text) => progress?.note(text));
  writeFiles(files);
  progress?.conclude(summarize(words, commands.model, result));
}

function fail(error: unknown, words: Words): void {
  const message = error instanceof Error ? error.message : String(error);
  const unknown = new Exit(
    exitStatus.internal,
    ({ command }) => `foldwright: ${command.internal(message.replace(/\s+/g, ' '))}`,
  );
  const exit = error instanceof Exit ? error : unknown;
  const line = exit.lineIn(words);
  if (line !== '') console.error(line);
  process.exitCode = exit.status;
}

/** Loaded when it is asked for. */
async function runBatch(args: string[], words: Words): Promise<void> {
  const { batch } = await import('./batch/batch.js');
  process.exitCode = await batch(args, words);
}

/**
 * A model in, nets on paper and a report out, or with `batch` many models; sets the exit status and never
 * rejects.
 */
export async function main(args: string[]): Promise<void> {
  const words = await loadWords(wantedLanguage(args));
  const [first, ...rest] = args;
  try {
    await (first === 'batch' ? runBatch(rest, words) : runOne(args, words));
  } catch (error) {
    fail(error, words);
  }
}
