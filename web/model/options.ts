/** The table of options: parsing, help, defaults and the report's echo all come from here. */
import { defaultOptions } from './default-options.js';
import type { JobOptions } from './job-options.js';
import { defaultPrint, dpiRange, measurable, type PrintOptions } from './print-options.js';
import {
  choice,
  colour,
  dashes,
  decimal,
  paper,
  pair,
  whole,
  wordOr,
  type Parser,
} from './option-values.js';

/** An option with a value. */
export interface Row<Value> {
  /** How help writes the value. */
  value: string;
  help: string;
  /** As a person would write it. */
  fallback: string;
  parse: Parser<Value>;
}

function row<const Value>(
  value: string,
  fallback: string | number,
  parse: Parser<Value>,
  help: string,
): Row<Value> {
  return { value, fallback: String(fallback), parse, help };
}

// Far more than a mesh that anyone could glue; larger numbers are typing errors.
const manyFaces = 10_000_000;

// Thinner lines vanish, thicker ones hide what they mark.
const lineWidth = decimal(0.01, 2);

const width = (lines: string): Row<number | 'style'> =>
  row('MM|style', 'style', wordOr('style', lineWidth), `width of ${lines}`);

const dash = (lines: string): Row<number[] | 'style'> =>
  row('MM,MM,..|solid|style', 'style', wordOr('style', dashes), `dashes and gaps of ${lines}`);

const colourOf = (lines: string): Row<string> =>
  row('#RRGGBB|style', 'style', wordOr('style', colour), `colour of ${lines}`);

export const rows = {
  parts: row('K|auto', 'auto', wordOr('auto', whole(1, manyFaces)), 'number of parts'),
  nets: row(
    'NAME',
    'new',
    choice(['new', 'file']),
    'file: keep the nets and flaps that the file brings along (PDO); new: search others',
  ),
  solver: row(
    'NAME',
    defaultOptions.solver,
    choice(['tree', 'genetic']),
    'tree: local search on spanning trees; genetic: evolution, as published',
  ),
  heuristic: row(
    'NAME',
    defaultOptions.heuristic,
    choice(['steepest', 'flat', 'hybrid', 'random']),
    'for the learning: steepest, flat, hybrid or random',
  ),
  segment: row(
    'NAME',
    defaultOptions.segment,
    choice(['merge', 'spectral']),
    'merge: foldability with shape cues; spectral: foldability alone',
  ),
  runs: row('N', defaultOptions.runs, whole(1, 65_535), 'learning runs'),
  proxy: row(
    'N',
    defaultOptions.proxy,
    whole(0, manyFaces),
    'learn on a proxy above N faces; 0: never',
  ),
  seed: row('N', defaultOptions.seed, whole(0, 2 ** 32 - 1), 'the same seed gives the same result'),
  faces: row('N|off', 'off', wordOr('off', whole(4, manyFaces)), 'simplify to N triangles first'),
  folding: row(
    'MODE',
    defaultOptions.folding,
    choice(['require', 'prefer', 'off']),
    'nets without a folding motion: require: split; prefer: report; off: do not look',
  ),
  clearance: row(
    'F',
    defaultOptions.clearance,
    decimal(0.0001, 0.2),
    'how far apart faces stay while folding, in mean edge lengths',
  ),
  height: row(
    'MM|none',
    'none',
    wordOr('none', decimal(1, 100_000)),
    'finished height, from below to above; pieces too large for the sheet are cut again',
  ),
  width: row(
    'MM|none',
    'none',
    wordOr('none', decimal(1, 100_000)),
    'finished width: along x, or along y with x up',
  ),
  depth: row(
    'MM|none',
    'none',
    wordOr('none', decimal(1, 100_000)),
    'finished depth: along z, or along y with z up',
  ),
  up: row(
    'AXIS|guess',
    defaultOptions.up,
    choice(['guess', 'x', 'y', 'z']),
    'axis of the file that points up: x, y or z; guess: z for STL, else y',
  ),
  scale: row(
    'F|none',
    'none',
    wordOr('none', decimal(0.000001, 1_000_000)),
    'finished size as a factor on the size in the model’s unit',
  ),
  sheets: row('N|none', 'none', wordOr('none', whole(1, 1000)), 'as large as goes on N sheets'),
  unit: row(
    'NAME|guess',
    'guess',
    choice(['guess', 'mm', 'cm', 'm', 'in']),
    'unit of the model: mm, cm, m or in',
  ),
  paper: row('SIZE', 'A4', paper, 'A2 to A5, Letter, Legal, Tabloid, 12x12in, or WxH in mm'),
  orientation: row(
    'NAME',
    defaultOptions.orientation,
    choice(['auto', 'portrait', 'landscape']),
    'auto, portrait or landscape',
  ),
  margin: row('MM', defaultOptions.margin, decimal(0, 1000), 'margin that stays free'),
  flaps: row(
    'MM|none',
    defaultOptions.flapHeight,
    wordOr('none', decimal(1, 50)),
    'height of flaps; lower ones where there is no room',
  ),
  'flap-angle': row(
    'DEG',
    defaultOptions.flapAngle,
    decimal(10, 60),
    'angle of their sides at the base, at most',
  ),
  'flap-side': row(
    'NAME',
    'one',
    choice(['one', 'alternate', 'both']),
    'one: the side with more room; alternate: in turn; both',
  ),
  'flap-borders': row(
    'on|off',
    'off',
    choice(['on', 'off']),
    'on: open borders of the model get flaps as well',
  ),
  'glue-strips': row(
    'NAME',
    defaultOptions.glueStrips,
    choice(['none', 'free', 'all']),
    'loose strips for edges without a flap: none; free: where sheets have room; all: on further sheets, too',
  ),
  ids: row(
    'NAME',
    defaultOptions.ids,
    choice(['inside', 'flap', 'both', 'outside', 'none']),
    'where the numbers of cut edges go: on faces (inside), flaps (flap) or both, on flaps and what is cut off (outside), or none',
  ),
  'min-piece': row(
    'MM|off',
    'off',
    wordOr('off', decimal(0.1, 1000)),
    'bodies of the model that are smaller are not printed, and told',
  ),
  compact: row(
    'on|off',
    'on',
    choice(['on', 'off']),
    'on: nets with room for flaps, small outlines and strong necks; off: as they were found',
  ),
  workers: row(
    'N|auto',
    'auto',
    wordOr('auto', whole(1, 64)),
    'threads; auto: one per core, at most 4; any number gives the same result',
  ),
  'flat-fold': row(
    'DEG',
    defaultPrint.flatFold,
    decimal(0, 180),
    'folds flatter than this are not drawn',
  ),
  style: row(
    'NAME',
    defaultPrint.style,
    choice(['foldwright', 'pepakura', 'blender']),
    'how lines look: foldwright, pepakura or blender',
  ),
  'cut-width': width('cuts'),
  'cut-colour': colourOf('cuts'),
  'mountain-width': width('mountain folds'),
  'mountain-dash': dash('mountain folds'),
  'mountain-colour': colourOf('mountain folds'),
  'valley-width': width('valley folds'),
  'valley-dash': dash('valley folds'),
  'valley-colour': colourOf('valley folds'),
  'flap-colour': row(
    '#RRGGBB|none|style',
    'style',
    wordOr('style', wordOr('none', colour)),
    'what flaps are filled with',
  ),
  'fold-ticks': row(
    'on|off',
    'off',
    choice(['on', 'off']),
    'on: folds are marks of 3 mm at both ends, or a third of the fold, instead of lines across the picture',
  ),
  duplex: row(
    'on|off',
    'off',
    choice(['on', 'off']),
    'on: behind each sheet a page with its folds, mirrored, to print on both sides, turned along the long edge (PDF)',
  ),
  'fold-angles': row(
    'on|off',
    'off',
    choice(['on', 'off']),
    'print beside folds how far they fold',
  ),
  legend: row('on|off', 'on', choice(['on', 'off']), 'print once what lines and numbers mean'),
  assembly: row(
    'on|off',
    'off',
    choice(['on', 'off']),
    'on: pages with a cover, a list of pieces and the steps to build the model (PDF, SVG, PNG)',
  ),
  measured: row(
    'XMM,YMM|off',
    'off',
    wordOr('off', pair(decimal(measurable.least, measurable.most))),
    'what the printed rulers of 50 mm measure, across and up: corrects the printer’s scale',
  ),
  machine: row(
    'NAME',
    defaultPrint.machine,
    choice(['none', 'silhouette', 'cricut', 'generic']),
    'for a cutting machine: lines to cut, score and draw in pure colours; none: for scissors',
  ),
  dpi: row(
    'N',
    defaultPrint.dpi,
    whole(dpiRange.least, dpiRange.most),
    'pixels to the inch of PNG files, and of the colours and pictures of the model in all files',
  ),
  texture: row(
    'on|off|auto',
    defaultPrint.texture,
    choice(['on', 'off', 'auto']),
    'print faces in the colours and pictures of the model; auto: where it has some, without --colour part',
  ),
  colour: row(
    'NAME',
    defaultPrint.colour,
    choice(['part', 'none']),
    'part: print each piece in the colour of its part, unless --texture on finds some in the model',
  ),
  'flap-bleed': row(
    'NAME',
    defaultPrint.flapBleed,
    choice(['none', 'half', 'whole']),
    'how much of a flap gets the colours of its face: none, half or whole',
  ),
} satisfies Record<string, Row<unknown>>;

export type Settings = {
  [Name in keyof typeof rows]: ReturnType<(typeof rows)[Name]['parse']>;
};

/** The settings as a person would write them, by the names of the options. */
export function echo(settings: Settings): Record<string, unknown> {
  return { ...settings, paper: settings.paper.name };
}

/** The options of which at most one may be given. */
export const sizings = ['height', 'width', 'depth', 'scale', 'sheets'] as const;

function sizeOptions(settings: Settings): Pick<JobOptions, 'sizing' | 'size'> {
  for (const sizing of sizings) {
    const size = settings[sizing];
    if (size !== 'none') return { sizing, size };
  }
  return { sizing: 'fit', size: 0 };
}

function flapOptions(
  settings: Settings,
): Pick<JobOptions, 'flapSide' | 'flapHeight' | 'flapAngle' | 'flapBorders' | 'glueStrips'> {
  const { flaps } = settings;
  return {
    flapSide: flaps === 'none' ? 'none' : settings['flap-side'],
    flapHeight: flaps === 'none' ? defaultOptions.flapHeight : flaps,
    flapAngle: settings['flap-angle'],
    flapBorders: settings['flap-borders'] === 'on',
    glueStrips: settings['glue-strips'],
  };
}

/** The values among `values` that are not left to the style. */
function given<Values extends object>(values: Values): Partial<Values> {
  const entries = Object.entries(values).filter(([, value]) => value !== 'style');
  return Object.fromEntries(entries) as Partial<Values>;
}

/** How the sheets shall look. */
export function printOptions(settings: Settings): PrintOptions {
  const kind = (width: unknown, colour: unknown, dash: unknown = 'style'): object =>
    given({ width, colour, dash });
  const flaps = settings['flap-colour'];
  return {
    style: settings.style,
    lines: {
      cut: kind(settings['cut-width'], settings['cut-colour']),
      mountain: kind(
        settings['mountain-width'],
        settings['mountain-colour'],
        settings['mountain-dash'],
      ),
      valley: kind(settings['valley-width'], settings['valley-colour'], settings['valley-dash']),
    },
    ...(flaps !== 'style' && { flaps }),
    flatFold: settings['flat-fold'],
    foldTicks: settings['fold-ticks'] === 'on',
    duplex: settings.duplex === 'on',
    foldAngles: settings['fold-angles'] === 'on',
    legend: settings.legend === 'on',
    assembly: settings.assembly === 'on',
    measured: settings.measured === 'off' ? defaultPrint.measured : settings.measured,
    machine: settings.machine,
    dpi: settings.dpi,
    texture: settings.texture,
    colour: settings.colour,
    flapBleed: settings['flap-bleed'],
  };
}

/** What the engine is asked for. */
export function jobOptions(settings: Settings): JobOptions {
  const { parts, faces, heuristic, segment, solver, folding, clearance, runs, proxy, seed } =
    settings;
  return {
    parts: parts === 'auto' ? 0 : parts,
    heuristic,
    segment,
    solver,
    folding,
    clearance,
    runs,
    proxy,
    seed,
    faces: faces === 'off' ? 0 : faces,
    up: settings.up,
    ...sizeOptions(settings),
    ...flapOptions(settings),
    // Edges, parts and pieces are chosen where they can be seen.
    flapEdges: [],
    locks: [],
    names: [],
    pins: [],
    ids: settings.ids,
    compaction: settings.compact === 'on',
    unit: settings.unit,
    paperWidth: settings.paper.width,
    paperHeight: settings.paper.height,
    orientation: settings.orientation,
    margin: settings.margin,
    minPiece: settings['min-piece'] === 'off' ? 0 : settings['min-piece'],
  };
}
