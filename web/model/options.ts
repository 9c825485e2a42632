/** The table of options: parsing, help, defaults and the report's echo all come from here. */
import { defaultOptions, flapHeights } from './default-options.js';
import { fillRange, widestHole } from './holes.js';
import type { JobOptions } from './job-options.js';
import { languages, usualLanguage } from './languages.js';
import {
  defaultPrint,
  dpiRange,
  measurable,
  thicknessRange,
  type PrintOptions,
} from './print-options.js';
import {
  choice,
  colour,
  dashes,
  decimal,
  paper,
  pair,
  repairsOff,
  whole,
  wordOr,
  type Parser,
} from './option-values.js';
import { writtenRepair } from './repair-steps.js';

/** An option with a value; what help says of it is in `web/words`. */
export interface Row<Value> {
  /** How help writes the value. */
  value: string;
  /** As a person would write it. */
  fallback: string;
  parse: Parser<Value>;
  /** Whether it may be given several times: the values then count together, as one list with commas. */
  repeats?: true;
}

function row<const Value>(
  value: string,
  fallback: string | number,
  parse: Parser<Value>,
): Row<Value> {
  return { value, fallback: String(fallback), parse };
}

// Far more than a mesh that anyone could glue; larger numbers are typing errors.
const manyFaces = 10_000_000;

// Thinner lines vanish, thicker ones hide what they mark.
const lineWidth = decimal(0.01, 2);

const width = (): Row<number | 'style'> => row('MM|style', 'style', wordOr('style', lineWidth));

const dash = (): Row<number[] | 'style'> =>
  row('MM,MM,..|solid|style', 'style', wordOr('style', dashes));

const colourOf = (): Row<string> => row('#RRGGBB|style', 'style', wordOr('style', colour));

export const rows = {
  parts: row('K|auto', 'auto', wordOr('auto', whole(1, manyFaces))),
  nets: row('NAME', 'new', choice(['new', 'file'])),
  solver: row('NAME', defaultOptions.solver, choice(['tree', 'genetic'])),
  heuristic: row(
    'NAME',
    defaultOptions.heuristic,
    choice(['steepest', 'flat', 'hybrid', 'random']),
  ),
  segment: row('NAME', defaultOptions.segment, choice(['merge', 'spectral'])),
  runs: row('N', defaultOptions.runs, whole(1, 65_535)),
  proxy: row('N', defaultOptions.proxy, whole(0, manyFaces)),
  seed: row('N', defaultOptions.seed, whole(0, 2 ** 32 - 1)),
  faces: row('N|off', 'off', wordOr('off', whole(4, manyFaces))),
  repair: { ...row('STEP=on|off,..', 'on', repairsOff), repeats: true },
  'fill-holes': row(
    'PERCENT|all|off',
    'off',
    wordOr('all', wordOr('off', decimal(fillRange.least, fillRange.most))),
  ),
  inside: row('keep|drop', 'keep', choice(['keep', 'drop'])),
  crossing: row('keep|unite', 'keep', choice(['keep', 'unite'])),
  folding: row('MODE', defaultOptions.folding, choice(['require', 'prefer', 'off'])),
  clearance: row('F', defaultOptions.clearance, decimal(0.0001, 0.2)),
  height: row('MM|none', 'none', wordOr('none', decimal(1, 100_000))),
  width: row('MM|none', 'none', wordOr('none', decimal(1, 100_000))),
  depth: row('MM|none', 'none', wordOr('none', decimal(1, 100_000))),
  up: row('AXIS|guess', defaultOptions.up, choice(['guess', 'x', 'y', 'z'])),
  scale: row('F|none', 'none', wordOr('none', decimal(0.000001, 1_000_000))),
  sheets: row('N|none', 'none', wordOr('none', whole(1, 1000))),
  unit: row('NAME|guess', 'guess', choice(['guess', 'mm', 'cm', 'm', 'in'])),
  paper: row('SIZE', 'A4', paper),
  orientation: row('NAME', defaultOptions.orientation, choice(['auto', 'portrait', 'landscape'])),
  margin: row('MM', defaultOptions.margin, decimal(0, 1000)),
  flaps: row(
    'MM|none',
    defaultOptions.flapHeight,
    wordOr('none', decimal(flapHeights.least, flapHeights.most)),
  ),
  'flap-angle': row('DEG', defaultOptions.flapAngle, decimal(10, 60)),
  'flap-style': row('NAME', defaultOptions.flapStyle, choice(['edge', 'run', 'zigzag'])),
  'flap-side': row('NAME', 'one', choice(['one', 'alternate', 'both'])),
  'flap-borders': row('on|off', 'off', choice(['on', 'off'])),
  'glue-strips': row('NAME', defaultOptions.glueStrips, choice(['none', 'free', 'all'])),
  ids: row('NAME', defaultOptions.ids, choice(['inside', 'flap', 'both', 'outside', 'none'])),
  'min-piece': row('MM|off', 'off', wordOr('off', decimal(0.1, 1000))),
  compact: row('on|off', 'on', choice(['on', 'off'])),
  workers: row('N|auto', 'auto', wordOr('auto', whole(1, 64))),
  lang: row('CODE', usualLanguage, choice(languages)),
  'flat-fold': row('DEG', defaultPrint.flatFold, decimal(0, 180)),
  style: row('NAME', defaultPrint.style, choice(['foldwright', 'pepakura', 'blender'])),
  'cut-width': width(),
  'cut-colour': colourOf(),
  'mountain-width': width(),
  'mountain-dash': dash(),
  'mountain-colour': colourOf(),
  'valley-width': width(),
  'valley-dash': dash(),
  'valley-colour': colourOf(),
  'flap-colour': row('#RRGGBB|none|style', 'style', wordOr('style', wordOr('none', colour))),
  'fold-ticks': row('on|off', 'off', choice(['on', 'off'])),
  duplex: row('on|off', 'off', choice(['on', 'off'])),
  'fold-angles': row('on|off', 'off', choice(['on', 'off'])),
  thickness: row(
    'MM|off',
    'off',
    wordOr('off', decimal(thicknessRange.least, thicknessRange.most)),
  ),
  legend: row('on|off', 'on', choice(['on', 'off'])),
  assembly: row('on|off', 'off', choice(['on', 'off'])),
  measured: row(
    'XMM,YMM|off',
    'off',
    wordOr('off', pair(decimal(measurable.least, measurable.most))),
  ),
  machine: row('NAME', defaultPrint.machine, choice(['none', 'silhouette', 'cricut', 'generic'])),
  dpi: row('N', defaultPrint.dpi, whole(dpiRange.least, dpiRange.most)),
  texture: row('on|off|auto', defaultPrint.texture, choice(['on', 'off', 'auto'])),
  colour: row('NAME', defaultPrint.colour, choice(['part', 'none'])),
  shading: row('on|off', 'off', choice(['on', 'off'])),
  'flap-bleed': row('NAME', defaultPrint.flapBleed, choice(['none', 'half', 'whole'])),
} satisfies Record<string, Row<unknown>>;

export type Settings = {
  [Name in keyof typeof rows]: ReturnType<(typeof rows)[Name]['parse']>;
};

/** The settings as a person would write them, by the names of the options. */
export function echo(settings: Settings): Record<string, unknown> {
  return { ...settings, paper: settings.paper.name, repair: writtenRepair(settings.repair) };
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
): Pick<
  JobOptions,
  'flapSide' | 'flapHeight' | 'flapAngle' | 'flapStyle' | 'flapBorders' | 'glueStrips'
> {
  const { flaps } = settings;
  return {
    flapSide: flaps === 'none' ? 'none' : settings['flap-side'],
    flapHeight: flaps === 'none' ? defaultOptions.flapHeight : flaps,
    flapAngle: settings['flap-angle'],
    flapStyle: settings['flap-style'],
    flapBorders: settings['flap-borders'] === 'on',
    glueStrips: settings['glue-strips'],
  };
}

/** The widest holes that are filled, in percent. */
function fillOption(wish: Settings['fill-holes']): number {
  if (wish === 'off') return 0;
  return wish === 'all' ? widestHole : wish;
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
    language: settings.lang,
    flatFold: settings['flat-fold'],
    foldTicks: settings['fold-ticks'] === 'on',
    duplex: settings.duplex === 'on',
    foldAngles: settings['fold-angles'] === 'on',
    thickness: settings.thickness === 'off' ? defaultPrint.thickness : settings.thickness,
    legend: settings.legend === 'on',
    assembly: settings.assembly === 'on',
    measured: settings.measured === 'off' ? defaultPrint.measured : settings.measured,
    machine: settings.machine,
    dpi: settings.dpi,
    texture: settings.texture,
    colour: settings.colour,
    shading: settings.shading === 'on',
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
    repairOff: settings.repair,
    fillHoles: fillOption(settings['fill-holes']),
    dropInner: settings.inside === 'drop',
    unite: settings.crossing === 'unite',
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
