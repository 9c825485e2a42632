/** What a command line asks of a batch. */
import { Command, Option } from 'commander';
import { exportFormats, type ExportFormat } from '../../export/formats.js';
import { BadValue, whole } from '../../model/option-values.js';
import type { Settings } from '../../model/options.js';
import { addCommonOptions, givenRows, parsed, readArguments, settingsOf } from '../command-line.js';
import type { Words } from '../../words/words.js';
import { usageError } from '../exit.js';
import { checkFormat } from '../formats.js';

/** Formats of a batch: the report is one of them. */
const batchFormats = [...exportFormats, 'report'] as const;
export type BatchFormat = ExportFormat | 'report';

/** A share of the models, for a machine of several; counted from 1. */
export interface Shard {
  index: number;
  of: number;
}

export interface BatchCommands {
  /** Folders, models, and lists of both; `-` is a list on standard input. */
  sources: string[];
  /** The folder of all that is written. */
  out: string;
  /** In the order of `batchFormats`, each once. */
  formats: BatchFormat[];
  /** All models without one. */
  shard: Shard | null;
  quiet: boolean;
  settings: Settings;
  /** Names of the options that were written. */
  given: ReadonlySet<string>;
}

interface Flags {
  out: string;
  format: BatchFormat[];
  shard?: Shard;
  quiet?: boolean;
}

/** FORMAT,FORMAT */
function formats(text: string): BatchFormat[] {
  const wanted = text.split(',').map((word) => word.trim().toLowerCase());
  const known: readonly string[] = batchFormats;
  const unknown = wanted.some((word) => !known.includes(word));
  if (unknown) throw new BadValue({ expected: 'words', words: batchFormats });
  return batchFormats.filter((format) => wanted.includes(format));
}

// More machines than any catalogue has models.
const shardNumber = whole(1, 1_000_000);

/** I/N */
function shard(text: string): Shard {
  const [index = '', of = '', ...rest] = text.split('/');
  const found = { index: shardNumber(index), of: shardNumber(of) };
  const isShare = rest.length === 0 && found.index <= found.of;
  if (!isShare) throw new BadValue({ expected: 'words', words: ['I/N'] });
  return found;
}

function describe(words: Words): Command {
  const { help } = words.batch;
  const program = new Command('foldwright batch')
    .description(help.about)
    .usage(help.usage)
    .argument('<source...>', help.source)
    .requiredOption('--out <dir>', help.out)
    .addOption(
      new Option('--format <names>', help.format(batchFormats.join(', ')))
        .default(formats('pdf,report'), 'pdf,report')
        .argParser((text) => parsed('format', formats, text)),
    )
    .addOption(
      new Option('--shard <i/n>', help.shard).argParser((text) => parsed('shard', shard, text)),
    )
    .addHelpText('after', `\n${help.workers}`);
  addCommonOptions(program, words);
  return program;
}

/**
 * Reads the arguments after `batch`.
 * @throws Exit for anything that cannot be done, and after printing help or the version
 */
export function parseBatchLine(args: string[], words: Words): BatchCommands {
  const program = describe(words);
  readArguments(program, args);
  const { out, format, shard: share = null, quiet = false } = program.opts<Flags>();
  const settings = settingsOf(program);
  if (out === '') throw usageError(({ batch }) => batch.noFolder('--out'));
  for (const each of format) if (each !== 'report') checkFormat(`model.${each}`, settings);
  return {
    sources: program.args,
    out,
    formats: format,
    shard: share,
    quiet,
    settings,
    given: givenRows(program),
  };
}
