/** How a document begins: with a run, or with what a project holds. */
import { goOn } from '../api/go-on.js';
import type { Session } from '../api/session.js';
import type { WorkOptions } from '../api/work.js';
import { changedSettings } from '../api/written-options.js';
import { echo, type Settings } from '../model/options.js';
import { BadOption } from '../words/bad-option.js';
import type { Commands } from './command-line.js';
import { phraseOf } from '../words/phrase.js';
import { usageError } from './exit.js';

/** Options of this run alone, which change no document. */
const ofDevice: readonly string[] = ['workers', 'measured', 'lang'];

/** The options that were written, for a project. */
function givenOptions({ given, settings }: Commands): Record<string, unknown> {
  const written = Object.entries(echo(settings)).filter(
    ([name]) => given.has(name) && !ofDevice.includes(name),
  );
  return Object.fromEntries(written);
}

/** All options: those that were written, and for others what the project says, or what is usual. */
export function settingsFor(session: Session, commands: Commands): Settings {
  if (!session.settings) return commands.settings;
  try {
    return changedSettings(session.settings, givenOptions(commands));
  } catch (error) {
    if (!(error instanceof BadOption)) throw error;
    const { params } = error;
    throw usageError(({ optionFault }) => optionFault(params));
  }
}

/**
 * Makes the result from which the command line's edits start.
 * @throws Exit for edits of a project that are not possible under other options
 */
export async function begin(
  session: Session,
  commands: Commands,
  work: WorkOptions,
): Promise<void> {
  if (!session.settings) {
    await session.runWith(commands.settings, work);
    return;
  }
  const blocked = await goOn(session, givenOptions(commands), work);
  if (!blocked) return;
  const { refusal, step } = blocked;
  throw usageError((words) => words.command.aboutProjectEdit(step + 1, phraseOf(words, refusal)));
}
