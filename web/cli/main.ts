import { basename, extname, resolve } from 'node:path';
import { version } from '../../package.json';
import { runJob, type TimedResult } from '../core/client.js';
import { JobError } from '../core/job-error.js';
import { nodePool } from '../core/node-pool.js';
import { preparePrint, type Print } from '../export/print.js';
import { makeReport } from '../export/report.js';
import { parseCommandLine, type Commands } from './command-line.js';
import { Exit, exitStatus, usageError } from './exit.js';
import { readFontFile } from './font-file.js';
import { checkFormat, renderOutputs } from './formats.js';
import { exitOf } from './job-failure.js';
import { echo, jobOptions, printOptions } from './options.js';
import { Progress } from './progress.js';
import { readModelFile } from './read-model-file.js';
import { summarize } from './summary.js';
import { checkWritable, writeFiles, type OutputFile } from './write-files.js';

/** Everything about the outputs that can be wrong before the work has begun. */
function checkOutputs({ model, outputs, report }: Commands): void {
  outputs.forEach(checkFormat);
  const paths = report === null ? outputs : [...outputs, report];
  const taken = new Set([resolve(model)]);
  for (const path of paths) {
    if (taken.has(resolve(path))) throw usageError(`'${path}' is named twice`);
    taken.add(resolve(path));
  }
  paths.forEach(checkWritable);
}

/** Runs the job in workers, so that this thread hears signals at once. */
async function runEngine(commands: Commands, bytes: Uint8Array): Promise<TimedResult> {
  const { model, quiet, settings } = commands;
  const pool = nodePool(settings.workers === 'auto' ? undefined : settings.workers);
  const progress = quiet ? null : new Progress(process.stderr);
  try {
    return await runJob(pool, bytes, basename(model), jobOptions(settings), {
      onEvent: (event) => progress?.hear(event),
    });
  } catch (error) {
    throw error instanceof JobError ? exitOf(model, error) : error;
  } finally {
    progress?.clear();
    pool.close();
  }
}

function layOut({ model, settings }: Commands, result: TimedResult): Promise<Print> {
  return preparePrint({
    result,
    title: basename(model, extname(model)),
    margin: settings.margin,
    options: printOptions(settings),
    loadFont: readFontFile,
  });
}

function renderReport(
  { report, settings }: Commands,
  written: OutputFile[],
  result: TimedResult,
  print: Print,
): OutputFile[] {
  if (report === null) return [];
  const content = makeReport({
    version,
    options: echo(settings),
    job: jobOptions(settings),
    files: [...written.map(({ path }) => path), report],
    result,
    printed: print.notices,
    seconds: result.seconds,
  });
  return [{ path: report, content: `${JSON.stringify(content, null, 2)}\n` }];
}

async function run(args: string[]): Promise<void> {
  const commands = parseCommandLine(args);
  checkOutputs(commands);
  const result = await runEngine(commands, readModelFile(commands.model));
  const print = await layOut(commands, result);
  const files = await renderOutputs(commands.outputs, result, print);
  files.push(...renderReport(commands, files, result, print));
  writeFiles(files);
  if (files.length === 0) console.log(summarize(commands.model, result));
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
