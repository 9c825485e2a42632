import { Command, CommanderError, Option } from 'commander';
import { version } from '../../package.json';
import { exportFormats } from '../export/formats.js';
import type { DocumentEdit } from '../model/document-edits.js';
import { merge, partName, readEditsFile, split } from './edits.js';
import { exitStatus, Exit, usageError } from './exit.js';
import { rows, sizings, type Row, type Settings } from '../model/options.js';
import { BadValue, type Parser } from '../model/option-values.js';
import type { OptionFault } from '../words/messages.js';
import type { Words } from '../words/words.js';
import { helpIn, usageFaultOf } from './usage.js';

/** What a command line asks for. */
export interface Commands {
  model: string;
  outputs: string[];
  report: string | null;
  quiet: boolean;
  settings: Settings;
  /** Names of the options that were written: a project has its own for all others. */
  given: ReadonlySet<string>;
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

export function optionError(fault: OptionFault): Exit {
  return usageError(({ optionFault }) => optionFault(fault));
}

/** @throws Exit for a value that the parser does not take */
export function parsed<Value>(name: string, parse: Parser<Value>, text: string): Value {
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

/** How a row reads what is written for it, once or, where it may be, several times. */
function readerOf(name: string, row: Row<unknown>): (text: string) => unknown {
  const texts: string[] = [];
  return (text) => {
    const value = parsed(name, row.parse, text);
    texts.push(text);
    return row.repeats ? row.parse(texts.join(',')) : value;
  };
}

function addRows(program: Command, { optionHelp }: Words): void {
  for (const [name, row] of Object.entries<Row<unknown>>(rows)) {
    const help = optionHelp[name as keyof Settings];
    const option = new Option(`--${name} <${row.value}>`, help)
      .default(row.parse(row.fallback), row.fallback)
      .argParser(readerOf(name, row));
    program.addOption(option);
  }
}

const endings = exportFormats.map((format) => `.${format}`).join(', ');

function describe(words: Words): Command {
  const { command } = words;
  const program = new Command('foldwright')
    .description(command.about)
    .usage(command.usage)
    .argument('<model>', command.model)
    .option('-o, --output <file>', command.output(endings), collect)
    .option('--report <file>', command.report)
    .option('--split <part[:k]>', command.split, collect)
    .option('--merge <a,b>', command.merge, collect)
    .option('--edits <file>', command.edits)
    .option('--name <part=text>', command.name, collect)
    .addHelpText('after', `\n${command.manyModels('foldwright batch --help')}`);
  addCommonOptions(program, words);
  return program;
}

/** Adds what one model and many have in common: the options of a run, and how the program itself goes. */
export function addCommonOptions(program: Command, words: Words): void {
  const { command } = words;
  program
    .option('--quiet', command.quiet)
    .version(version, '-V, --version', command.version)
    .helpOption('-h, --help', command.help)
    .configureHelp(helpIn(words))
    .exitOverride()
    .configureOutput({ writeErr: () => undefined });
  addRows(program, words);
}

/** Commander keeps values under camel-case names; the table has the names that people write. */
function valueOf(program: Command, name: string): unknown {
  return program.getOptionValue(new Option(`--${name}`).attributeName());
}

/** The rows that somebody wrote, and did not leave as they are. */
export function givenRows(program: Command): Set<string> {
  const isGiven = (name: string): boolean =>
    program.getOptionValueSource(new Option(`--${name}`).attributeName()) === 'cli';
  return new Set(Object.keys(rows).filter(isGiven));
}

/** @throws Exit for options that cannot stand together */
export function settingsOf(program: Command): Settings {
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
  if (twice) throw usageError(({ command }) => command.namedAlready(twice.part));
  return names;
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

/** @throws Exit for arguments that the program does not take, and after printing help or the version */
export function readArguments(program: Command, args: string[]): void {
  try {
    program.parse(args, { from: 'user' });
  } catch (error) {
    if (!(error instanceof CommanderError)) throw error;
    if (error.exitCode === 0) throw new Exit(exitStatus.done);
    const fault = usageFaultOf(error);
    throw usageError(({ command }) => command.usageFault(fault));
  }
}

/**
 * Reads the arguments after the program's name.
 * @throws Exit for anything that cannot be done, and after printing help or the version
 */
export function parseCommandLine(args: string[], words: Words): Commands {
  const program = describe(words);
  readArguments(program, args);
  const { output = [], report, quiet = false, ...changes } = program.opts<Flags>();
  const { split: splits = [], merge: merges = [], edits, name = [] } = changes;
  const editWords = { split: splits, merge: merges, ...(edits !== undefined && { edits }), name };
  return {
    model: program.args[0]!,
    outputs: output,
    report: report ?? null,
    quiet,
    settings: settingsOf(program),
    given: givenRows(program),
    edits: stepsOf(editWords),
    editWords,
  };
}
