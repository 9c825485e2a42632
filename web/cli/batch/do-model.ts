/** One model of a batch, from its path to the files of its folder. */
import { JobError } from '../../core/job-error.js';
import type { Pool } from '../../core/pool.js';
import type { WrittenFile } from '../../export/formats.js';
import { modelThumbnail } from '../../export/model-thumbnail.js';
import { reportText } from '../../export/report-text.js';
import { assemblySteps } from '../../model/assembly-steps.js';
import { extentsOf } from '../../model/bounds.js';
import { buildingTime } from '../../model/building-time.js';
import type { ModelFiles } from '../../model/model-files.js';
import { conclusionOf, findingsOn } from '../../model/verdict.js';
import type { Words } from '../../words/words.js';
import type { Commands } from '../command-line.js';
import { unfoldModel, type Outcome } from '../engine-run.js';
import { Exit, exitStatus } from '../exit.js';
import { renderOutputs } from '../formats.js';
import { exitOf } from '../job-failure.js';
import { readModelFiles } from '../read-model-files.js';
import { remarks, reportFor } from '../tell-outcome.js';
import { JobTeller, type ModelEvent } from './batch-events.js';
import type { ListedModel } from './list-models.js';
import { fileTitle, pictureName } from './names.js';
import { isCurrent, originOf, readRecord, recordOf, type Fault, type Summary } from './record.js';
import type { SlotData, SlotOutcome } from './slot-protocol.js';

const utf8 = new TextEncoder();

/** The command line that would do this model alone. */
function commandsFor(
  model: ListedModel,
  { formats, given, settings }: SlotData['commands'],
): Commands {
  const title = fileTitle(model.name);
  return {
    model: model.path,
    outputs: formats.filter((format) => format !== 'report').map((each) => `${title}.${each}`),
    report: formats.includes('report') ? `${title}.json` : null,
    quiet: true,
    settings,
    given,
    edits: [],
    editWords: { split: [], merge: [], name: [] },
  };
}

/** The report, which tells nothing that changes from run to run. */
function reportFile(
  outcome: Outcome,
  words: Words,
  report: string,
  files: readonly WrittenFile[],
): WrittenFile {
  const names = [...files.map(({ name }) => name), report];
  const { options, seconds: _, ...rest } = reportFor(outcome, words, names);
  const { workers: __, ...lasting } = options;
  const text = reportText({ ...rest, options: lasting });
  return { name: report, bytes: utf8.encode(text) };
}

async function filesOf(
  name: string,
  words: Words,
  commands: Commands,
  outcome: Outcome,
): Promise<WrittenFile[]> {
  const outputs = await renderOutputs(commands.outputs, outcome);
  const files = outputs.map(({ path, content }) => {
    const bytes = typeof content === 'string' ? utf8.encode(content) : content;
    return { name: path, bytes };
  });
  if (commands.report !== null) files.push(reportFile(outcome, words, commands.report, files));
  const picture = await modelThumbnail(outcome.result, outcome.print);
  return picture ? [...files, { name: pictureName(name), bytes: picture }] : files;
}

function summaryOf(outcome: Outcome, words: Words): Summary {
  const { job, result, settings } = outcome;
  const { model, pieces, sheets } = result;
  const findings = findingsOn(result, job.margin);
  const conclusion = conclusionOf(findings);
  const text = words.verdict.headline(conclusion, conclusion.count);
  return {
    faces: model.faces.length / 3,
    parts: result.parts,
    pieces: pieces.length,
    sheets: sheets.length,
    size_mm: [...extentsOf(model.vertices)],
    building: buildingTime(result, assemblySteps(pieces, settings['flat-fold'])).glued,
    verdict: { level: conclusion.level, text },
    notices: remarks(outcome, words),
    result_hash: result.hash,
  };
}

/** What came out in place of nets. */
function faultOf(path: string, words: Words, error: unknown): Fault {
  const exit = error instanceof JobError ? exitOf(path, error) : error;
  const isRefused = exit instanceof Exit && exit.status !== exitStatus.internal;
  const status = isRefused ? 'refused' : 'failed';
  const code = error instanceof JobError ? error.code : isRefused ? 'unreadable' : 'internal';
  if (exit instanceof Exit) return { status, code, text: exit.reasonIn(words) };
  return { status, code, text: error instanceof Error ? error.message : String(error) };
}

export interface Doing extends Pick<SlotData, 'commands'> {
  pool: Pool;
  words: Words;
  tell: (event: ModelEvent) => void;
}

/** Unfolds a model unless all of it is there already; never rejects. */
export async function doModel(model: ListedModel, doing: Doing): Promise<SlotOutcome> {
  const { commands, pool, tell, words } = doing;
  const { out } = commands;
  const start = performance.now();
  const seconds = (): number => (performance.now() - start) / 1000;
  let origin = originOf(commands, null);
  try {
    const files: ModelFiles = readModelFiles(model.path);
    origin = originOf(commands, files);
    const before = readRecord(out, model.name);
    if (before && isCurrent(before, origin, { out, name: model.name })) {
      return { isCurrent: true, record: before, files: [], seconds: seconds() };
    }
    const single = commandsFor(model, commands);
    const teller = new JobTeller(words, tell);
    const listener = {
      onEvent: teller.onEvent.bind(teller),
      // What an option does not do is the same for all models: the batch tells it once.
      note: () => undefined,
    };
    const outcome = await unfoldModel(single, files, { pool, listener, words });
    const made = await filesOf(model.name, words, single, outcome);
    const notes = made.map(({ name, bytes }) => ({ name, bytes: bytes.length }));
    const record = recordOf(origin, {
      status: 'done',
      files: notes,
      summary: summaryOf(outcome, words),
    });
    return { isCurrent: false, record, files: made, seconds: seconds() };
  } catch (error) {
    const record = recordOf(origin, faultOf(model.path, words, error));
    return { isCurrent: false, record, files: [], seconds: seconds() };
  }
}
