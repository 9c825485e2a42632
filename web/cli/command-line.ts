import { Command, CommanderError, Option } from 'commander';
import { version } from '../../package.json';
import { exportFormats, type ExportFormat } from '../export/formats.js';
import type { DocumentEdit } from '../model/document-edits.js';
import { merge, partName, readEditsFile, split } from './edits.js';
import { exitStatus, Exit, usageError } from './exit.js';
import { formatOf } from './formats.js';
import { idleOptions } from './idle-options.js';
import { rows, sizings, type Row, type Settings } from '../model/options.js';
import { BadValue, type Parser } from '../model/option-values.js';
import { optionWords } from '../words/en-options.js';
import type { OptionFault } from '../words/messages.js';

/** What a command line asks for. */
export interface Commands {
  model: string;
  outputs: string[];
  report: string | null;
  quiet: boolean;
  settings: Settings;
  /** What was asked for in vain, in phrases for people. */
  idle: string[];
  /** What is to be changed in what comes out, one step after the other; each is made in one go. */
  edits: (readonly DocumentEdit[])[];
  /** The same, as it was written. */
  editWords: EditWords;
}

/** Values of the options that change parts. */
export interface EditWords {
  split: string[];
  merge: string[];
  edits?: string;
  name: string[];
}

interface Flags extends Partial<EditWords> {
  output?: string[];
  report?: string;
  quiet?: boolean;
}

function optionError(fault: OptionFault): Exit {
  return usageError(optionWords(fault));
}

/** @throws Exit for a value that the parser does not take */
function parsed<Value>(name: string, parse: Parser<Value>, text: string): Value {
  try {
    return parse(text);
  } catch (error) {
    if (!(error instanceof BadValue)) throw error;
    throw optionError({ what: 'value', option: `--${name}`, value: text, ...error.fault });
  }
}

/** For an option that may be given several times. */
function collect(text: string, texts: string[] = []): string[] {
  return [...texts, text];
}

function addRows(program: Command): void {
  for (const [name, row] of Object.entries<Row<unknown>>(rows)) {
    const option = new Option(`--${name} <${row.value}>`, row.help)
      .default(row.parse(row.fallback), row.fallback)
      .argParser((text) => parsed(name, row.parse, text));
    program.addOption(option);
  }
}

const endings = exportFormats.map((format) => `.${format}`).join(', ');

function describe(): Command {
  const program = new Command('foldwright')
    .description('Unfolds a 3D model into paper nets.')
    .argument(
      '<model>',
      'OBJ, STL, OFF, PLY, GLB, glTF, 3MF or PDO file, or a folder or ZIP archive with one and what belongs to it',
    )
    .option(
      '-o, --output <file>',
      `write a file, as its ending says: ${endings}; may be given several times`,
      collect,
    )
    .option('--report <file>', 'write a report as JSON')
    .option(
      '--split <part[:k]>',
      'split this part of what comes out, counted from 1, into k (2) parts; may be given several times',
      collect,
    )
    .option('--merge <a,b>', 'merge these parts that touch; may be given several times', collect)
    .option('--edits <file>', 'then make these edits, a JSON list')
    .option(
      '--name <part=text>',
      'at last name this part, counted from 1; may be given several times',
      collect,
    )
    .option('--quiet', 'nothing on stderr but errors')
    .version(version)
    .exitOverride()
    .configureOutput({ writeErr: () => undefined });
  addRows(program);
  return program;
}

/** Commander keeps values under camel-case names; the table has the names that people write. */
function valueOf(program: Command, name: string): unknown {
  return program.getOptionValue(new Option(`--${name}`).attributeName());
}

/** The rows that somebody wrote, and did not leave as they are. */
function givenRows(program: Command): Set<string> {
  const isGiven = (name: string): boolean =>
    program.getOptionValueSource(new Option(`--${name}`).attributeName()) === 'cli';
  return new Set(Object.keys(rows).filter(isGiven));
}

function settingsOf(program: Command): Settings {
  const entries = Object.keys(rows).map((name) => [name, valueOf(program, name)]);
  const settings = Object.fromEntries(entries) as Settings;
  const { margin, paper } = settings;
  if (2 * margin >= paper.width) {
    throw optionError({
      what: 'no-paper-left',
      option: '--margin',
      margin_mm: margin,
      paper: paper.name,
    });
  }
  const given = sizings.filter((name) => settings[name] !== 'none');
  if (given.length > 1) {
    throw optionError({ what: 'second-size', option: `--${given[1]}`, first: `--${given[0]}` });
  }
  return settings;
}

/** @throws Exit for a part that is named twice */
function namesOf(texts: readonly string[]): DocumentEdit[] {
  const names = texts.map((text) => parsed('name', partName, text));
  const twice = names.find(({ part }, i) => names.some((other, j) => j < i && other.part === part));
  if (twice) throw usageError(`option '--name': part ${twice.part} has a name already`);
  return names;
}

function formatsOf(outputs: readonly string[]): ExportFormat[] {
  return outputs.flatMap((path) => formatOf(path) ?? []);
}

/** Splits and merges go by the parts of one result, and so are one step. */
function stepsOf({ split: splits, merge: merges, edits, name }: EditWords): Commands['edits'] {
  const together = [
    ...splits.map((text) => parsed('split', split, text)),
    ...merges.map((text) => parsed('merge', merge, text)),
  ];
  const listed = edits === undefined ? [] : readEditsFile(edits);
  const single = [...listed, ...namesOf(name)];
  return [...(together.length > 0 ? [together] : []), ...single.map((edit) => [edit])];
}

/**
 * Reads the arguments after the program's name.
 * @throws Exit for anything that cannot be done, and after printing help or the version
 */
export function parseCommandLine(args: string[]): Commands {
  const program = describe();
  try {
    program.parse(args, { from: 'user' });
  } catch (error) {
    if (!(error instanceof CommanderError)) throw error;
    if (error.exitCode === 0) throw new Exit(exitStatus.done, '');
    throw usageError(error.message.replace(/^error: /, ''));
  }
  const { output = [], report, quiet = false, ...words } = program.opts<Flags>();
  const { split: splits = [], merge: merges = [], edits, name = [] } = words;
  const editWords = { split: splits, merge: merges, ...(edits !== undefined && { edits }), name };
  const settings = settingsOf(program);
  return {
    model: program.args[0]!,
    outputs: output,
    report: report ?? null,
    quiet,
    settings,
    idle: idleOptions(givenRows(program), settings, formatsOf(output)),
    edits: stepsOf(editWords),
    editWords,
  };
}
