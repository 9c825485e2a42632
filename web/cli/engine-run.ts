/** One model by the engine: from its files to all that outputs are made of. */
import { jobOf } from '../api/document-state.js';
import type { Refusal } from '../api/edit-plan.js';
import { open } from '../api/node.js';
import type { Session } from '../api/session.js';
import type { TimedResult } from '../core/client.js';
import type { Pool } from '../core/pool.js';
import type { TimedEvent } from '../core/protocol.js';
import type { Print } from '../export/print.js';
import type { DocumentEdit } from '../model/document-edits.js';
import type { JobOptions } from '../model/job-options.js';
import type { ModelFiles } from '../model/model-files.js';
import type { Settings } from '../model/options.js';
import { phraseOf } from '../words/phrase.js';
import type { Words } from '../words/words.js';
import { begin, settingsFor } from './begin.js';
import type { Commands } from './command-line.js';
import { usageError, type Exit } from './exit.js';
import { formatsOf } from './formats.js';
import { idleOptions } from './idle-options.js';

/** Hears how a run goes. */
export interface RunListener {
  onEvent: (event: TimedEvent) => void;
  /** Something to be told on a line of its own. */
  note: (text: string) => void;
}

export interface RunSurroundings {
  pool: Pool;
  listener: RunListener | null;
  words: Words;
}

/** What the command line's files are made of. */
export interface Outcome {
  /** What the engine was asked for in the end. */
  job: JobOptions;
  result: TimedResult;
  print: Print;
  settings: Settings;
  project: () => Promise<Uint8Array>;
}

/** Why a step cannot be made, and which of several it is. */
function refusedStep(step: readonly DocumentEdit[], edit: number | null, refusal: Refusal): Exit {
  const [first] = step;
  return usageError((words) => {
    const fault = phraseOf(words, refusal);
    if (first?.kind === 'name') return words.command.aboutName(first.text, fault);
    return edit === null ? fault : words.command.aboutEdit(edit, fault);
  });
}

/** Makes the edits that were asked for, in their order; refused ones end the program. */
async function edit(session: Session, { edits }: Commands): Promise<void> {
  for (const [index, step] of edits.entries()) {
    const made = await session.apply(step);
    if (made.ok) continue;
    throw refusedStep(step, edits.length > 1 ? index + 1 : null, made);
  }
}

/**
 * Unfolds a model and makes its edits.
 * @throws JobError for a model that cannot be used, Exit for what the command line asks for
 */
export async function unfoldModel(
  commands: Commands,
  files: ModelFiles,
  { pool, listener, words }: RunSurroundings,
): Promise<Outcome> {
  const { edits, given, outputs, settings } = commands;
  const measured = String(settings.measured);
  const onEvent = (event: TimedEvent): void => listener?.onEvent(event);
  // Nobody needs to know what is wrong with a result that is still to be changed.
  const onWorkEvent = (event: TimedEvent): void => {
    if (event.type !== 'notice') onEvent(event);
  };
  const session = await open(files, { pool });
  const all = settingsFor(session, commands);
  idleOptions(words, given, all, formatsOf(outputs)).forEach((text) => listener?.note(text));
  await begin(session, commands, { onEvent: edits.length === 0 ? onEvent : onWorkEvent });
  await edit(session, commands);
  const { result, wishes } = await session.state();
  const print = await session.print(given.has('measured') ? { measured } : {});
  const project = async (): Promise<Uint8Array> => (await session.export('foldwright'))[0]!.bytes;
  return { job: jobOf(wishes), result, print, settings: all, project };
}
