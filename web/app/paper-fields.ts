import { sizings, type Settings } from '../model/options.js';
import type { FieldValues } from './pending-settings.js';

/** What the form's fields of sheets, size, flaps and numbers hold for settings, by their ids. */
export function paperFields(settings: Settings): FieldValues {
  const sizing = sizings.find((name) => settings[name] !== 'none');
  const fields = new Map([
    ['paper', settings.paper.name],
    ['orientation', settings.orientation],
    ['margin', String(settings.margin)],
    ['sizing', sizing ?? 'fit'],
    ['size', sizing ? String(settings[sizing]) : ''],
    ['flap-style', settings['flap-style']],
    ['flap-side', settings.flaps === 'none' ? 'none' : settings['flap-side']],
    ['strips', String(settings['glue-strips'] !== 'none')],
    ['ids', settings.ids],
  ]);
  // Without flaps the field for their height keeps what it has.
  if (settings.flaps !== 'none') fields.set('flap-height', String(settings.flaps));
  return fields;
}

/** What the form's other fields hold for settings, by their ids, but for the number of triangles. */
export function methodFields(settings: Settings): FieldValues {
  const { parts, seed, solver, segment, heuristic, runs, proxy, folding, unit, up } = settings;
  return new Map([
    ['parts', parts === 'auto' ? '' : String(parts)],
    ['seed', String(seed)],
    ['solver', solver],
    ['segment', segment],
    ['heuristic', heuristic],
    ['runs', String(runs)],
    ['proxy', String(proxy)],
    ['folding-mode', folding],
    ['unit', unit],
    ['up', up],
  ]);
}
