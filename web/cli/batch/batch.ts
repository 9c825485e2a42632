/** Many models, one after the other on each core; killed at any moment and started again it ends with the same files. */
import { mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { version } from '../../../package.json';
import type { Words } from '../../words/words.js';
import { exitStatus, usageError } from '../exit.js';
import { idleOptions } from '../idle-options.js';
import { reasonOf } from '../read-model-files.js';
import { writeFiles } from '../write-files.js';
import { parseBatchLine, type BatchCommands, type Shard } from './batch-line.js';
import { batchPage, type PageEntry } from './batch-page.js';
import { BatchReporter } from './batch-reporter.js';
import { listModels, type ListedModel } from './list-models.js';
import { tidyBeside, writeFolder } from './model-folder.js';
import { pictureName, placeOf, recordName } from './names.js';
import { originOf, readRecord, recordOf, recordText, type ModelRecord } from './record.js';
import type { SlotOutcome } from './slot-protocol.js';
import { doModels } from './slots.js';

const pageName = 'index.html';
const utf8 = new TextEncoder();

/** @throws Exit if there can be no such folder */
function makeFolder(out: string): void {
  try {
    mkdirSync(out, { recursive: true });
  } catch (error) {
    const told = reasonOf(error);
    throw usageError((words) => words.command.aboutFile(out, told(words)));
  }
}

/** Every so many-th model, so that each share has models of all folders. */
function shareOf(models: readonly ListedModel[], shard: Shard | null): ListedModel[] {
  return models.filter((_, i) => shard === null || i % shard.of === shard.index - 1);
}

function pageEntry(out: string, { label, name }: ListedModel): PageEntry {
  const record = readRecord(out, name);
  const file = pictureName(name);
  const hasPicture = record?.status === 'done' && record.files.some((each) => each.name === file);
  return {
    name,
    label,
    record,
    picture: hasPicture ? readFileSync(placeOf(out, name, file)) : null,
  };
}

/**
 * Writes the page of all models by what lies in their folders. One share of several does it only when nothing is
 * missing any more: the last of them that ends.
 */
function writePage(
  words: Words,
  models: readonly ListedModel[],
  { out, shard }: BatchCommands,
): void {
  const entries = models.map((model) => pageEntry(out, model));
  if (shard && entries.some(({ record }) => record === null)) return;
  writeFiles([{ path: join(out, pageName), content: batchPage(words, entries) }]);
}

/** Removes what a batch that was killed has left; another share may be writing just now. */
function tidy(models: readonly ListedModel[], { out, shard }: BatchCommands): void {
  for (const { name } of models) tidyBeside(placeOf(out, name));
  if (shard) return;
  const left = readdirSync(out).filter((name) => /^\.index\.html\..*\.part$/.test(name));
  for (const name of left) rmSync(join(out, name), { force: true });
}

/** Puts what became of a model where the next batch finds it. */
function keep(out: string, name: string, record: ModelRecord, files: SlotOutcome['files']): void {
  const text = { name: recordName(name), bytes: utf8.encode(recordText(record)) };
  writeFolder(placeOf(out, name), [...files, text]);
}

/** Hears signals that ask the program to end; a second one ends it at once. */
function endOnSignals(): AbortSignal {
  const end = new AbortController();
  for (const signal of ['SIGINT', 'SIGTERM'] as const) {
    process.removeAllListeners(signal);
    process.once(signal, () => end.abort());
  }
  // Who listened has gone: so does the batch.
  process.stdout.once('error', () => end.abort());
  return end.signal;
}

function statusOf({ failed, left, refused }: BatchReporter): number {
  if (left > 0) return exitStatus.cancelled;
  if (failed.length > 0) return exitStatus.internal;
  return refused.length > 0 ? exitStatus.model : exitStatus.done;
}

/**
 * Unfolds many models, by the arguments after `batch`.
 *
 * @returns the exit status: 0 if all are done, 1 if the program failed at some, 3 if some cannot be used, 4 if a
 * signal has ended it
 * @throws Exit for anything that cannot be done at all
 */
export async function batch(args: string[], words: Words): Promise<number> {
  const commands = parseBatchLine(args, words);
  const { formats, given, out, quiet, settings, shard } = commands;
  makeFolder(out);
  const models = listModels(commands.sources, out);
  const share = shareOf(models, shard);
  const signal = endOnSignals();
  const reporter = new BatchReporter(share.length, words, quiet);
  const written = formats.filter((format) => format !== 'report');
  idleOptions(words, given, settings, written).forEach((text) => reporter.note(text));
  reporter.tell({ type: 'begin', version, models: share.length, ...(shard && { shard }) });
  tidy(share, commands);
  const onOutcome = (model: ListedModel, outcome: SlotOutcome): void => {
    if (!outcome.isCurrent) keep(out, model.name, outcome.record, outcome.files);
    reporter.onOutcome(model, outcome);
  };
  await doModels(
    share,
    {
      commands: { formats, given, out, settings },
      threads: settings.workers === 'auto' ? availableParallelism() : settings.workers,
    },
    {
      signal,
      listener: {
        onBegin: (model) => reporter.onBegin(model),
        onEvent: (model, event) => reporter.onEvent(model, event),
        onOutcome,
        onDeath(model, reason) {
          const fault = {
            status: 'failed',
            code: 'internal',
            text: words.batch.died(reason(words)),
          } as const;
          const record = recordOf(originOf(commands, null), fault);
          onOutcome(model, { isCurrent: false, record, files: [], seconds: 0 });
        },
      },
    },
  );
  writePage(words, models, commands);
  reporter.end();
  return statusOf(reporter);
}
