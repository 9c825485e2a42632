/** What a person asks for that gives the page another result: a run, or a document that was kept. */
import { carryEdits, type CarriedEdits } from '../api/carry-edits.js';
import type { RunWork } from '../api/work.js';
import type { Settings } from '../model/options.js';
import { editedRun, newRun, type FinishedRun } from './finished-run.js';
import type { Inspector } from './inspector.js';
import type { ChosenModel } from './model-file.js';
import type { FieldValues } from './pending-settings.js';
import type { RunPictures } from './run-pictures.js';
import { ReplacedModel, sessionIn } from './replaced-model.js';
import type { OpenModel } from './store-needs.js';

export interface NextRun {
  model: ChosenModel;
  /** Gives the session with a result. */
  make(work: RunWork): Promise<OpenModel>;
  /** What the page is to show of it. @pre the session has a result */
  finished(session: OpenModel, pictures: RunPictures): Promise<FinishedRun>;
}

/** A run of a model. */
export function unfolding(
  model: ChosenModel,
  settings: Settings,
  fields: FieldValues,
  inspector: Pick<Inspector, 'open'>,
): NextRun {
  return {
    model,
    async make(work) {
      const session = await inspector.open(model);
      await session.runWith(settings, work);
      return session;
    },
    async finished(session, pictures) {
      const { result } = await session.state();
      const read = { ...model, name: result.file };
      return newRun({ model: read, settings, fields, pictures, result });
    },
  };
}

/**
 * A corrected model, with the options of the one whose place it takes and with those of its edits that fit.
 *
 * @param onCarried hears what has become of the edits
 */
export function replacing(
  model: ChosenModel,
  { session, run }: { session: OpenModel; run: FinishedRun },
  inspector: Pick<Inspector, 'open'>,
  onCarried: (carried: CarriedEdits) => void,
): NextRun {
  return {
    model,
    async make(work) {
      const before = sessionIn(session);
      const after = await inspector.open(model);
      await after.runWith(before.settings ?? run.settings, work);
      const { signal } = work;
      onCarried(await carryEdits(before, after, signal && { signal }));
      return new ReplacedModel(session, after);
    },
    async finished(made, pictures) {
      const state = await made.state();
      const { wishes, result } = state;
      const { settings } = wishes;
      const read = { ...model, name: result.file };
      const { fields } = run;
      return editedRun(newRun({ model: read, settings, fields, pictures, result }), state);
    },
  };
}

/** A document that was kept, which has its own settings. */
export function reopening(
  model: ChosenModel,
  fieldsOf: (settings: Settings) => FieldValues,
  open: () => Promise<OpenModel>,
): NextRun {
  return {
    model,
    async make(work) {
      const session = await open();
      await session.state(work);
      return session;
    },
    async finished(session, pictures) {
      const state = await session.state();
      const { wishes, result } = state;
      const { settings } = wishes;
      const read = { ...model, name: result.file };
      const fields = fieldsOf(settings);
      return editedRun(newRun({ model: read, settings, fields, pictures, result }), state);
    },
  };
}
