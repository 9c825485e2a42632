/** Options as addresses ask for them: `height=150&flaps=6`, by the names and values of the command line. */
import { changedSettings, defaultSettings } from '../api/written-options.js';
import { sizings, type Settings } from '../model/options.js';
import { methodFields, paperFields } from './paper-fields.js';
import type { FieldValues } from './pending-settings.js';

/** Options that fill in fields of the form. */
const askable: ReadonlySet<string> = new Set([
  'parts',
  'seed',
  'solver',
  'segment',
  'heuristic',
  'runs',
  'proxy',
  'folding',
  'unit',
  'up',
  ...sizings,
  'paper',
  'orientation',
  'margin',
  'flaps',
  'flap-side',
  'flap-style',
  'glue-strips',
  'ids',
] satisfies (keyof Settings)[]);

function fieldsOf(settings: Settings): FieldValues {
  return new Map([...paperFields(settings), ...methodFields(settings)]);
}

/**
 * The fields, by their ids, that are to hold something else than they do when nothing is asked for.
 *
 * @throws BadOption for an option that is none, that no field has, or whose value makes no sense
 */
export function askedFields(text: string): FieldValues {
  const asked = Object.fromEntries(new URLSearchParams(text));
  const usual = defaultSettings();
  const before = fieldsOf(usual);
  const fields = [...fieldsOf(changedSettings(usual, asked, askable))];
  return new Map(fields.filter(([id, value]) => before.get(id) !== value));
}
