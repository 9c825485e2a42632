/** Options as programs write them: the command line's names and values, in a plain object. */
import { BadValue } from '../model/option-values.js';
import { printOptions, rows, sizings, type Row, type Settings } from '../model/options.js';
import type { PaperSize } from '../model/paper.js';
import type { PrintOptions } from '../model/print-options.js';
import type { RepairStep } from '../model/repair-steps.js';
import { BadOption } from '../words/bad-option.js';

type CamelCase<Name extends string> = Name extends `${infer Head}-${infer Tail}`
  ? `${Head}${Capitalize<CamelCase<Tail>>}`
  : Name;

/** Steps of the repair that are switched off, or on again. */
export type RepairSwitches = Partial<Record<RepairStep, 'on' | 'off' | boolean>>;

/** Switches may be true or false, and those of the repair an object; lists and papers are as the command line has them: '1,0.5', 'A4' or '210x297'. */
type Written<Value> = [Value] extends ['on' | 'off']
  ? Value | boolean
  : [Value] extends [readonly RepairStep[]]
    ? RepairSwitches | string
    : Value extends PaperSize | readonly unknown[]
      ? string
      : Value;

type OptionName = Exclude<keyof Settings, 'workers'>;

/** Any of the command line's options, in camel case; what is not given keeps its value. */
export type Options = {
  [Name in OptionName as CamelCase<Name>]?: Written<Settings[Name]>;
};

/** Options that decide sheets, size, flaps and numbers: nets stay as they are. */
export const paperOptions: ReadonlySet<string> = new Set([
  ...sizings,
  'unit',
  'paper',
  'orientation',
  'margin',
  'flaps',
  'flap-angle',
  'flap-style',
  'flap-side',
  'flap-borders',
  'glue-strips',
  'ids',
  'min-piece',
] satisfies OptionName[]);

/** Options that decide how lines look: pieces and their places stay as they are. */
export const printOptionNames: ReadonlySet<string> = new Set([
  'flat-fold',
  'style',
  'cut-width',
  'cut-colour',
  'mountain-width',
  'mountain-dash',
  'mountain-colour',
  'valley-width',
  'valley-dash',
  'valley-colour',
  'flap-colour',
  'fold-ticks',
  'duplex',
  'fold-angles',
  'thickness',
  'legend',
  'assembly',
  'measured',
  'machine',
  'dpi',
  'texture',
  'colour',
  'shading',
  'flap-bleed',
] satisfies OptionName[]);

/** The command line's name of an option. */
export function nameOf(key: string): string {
  return key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}

/** A value as the command line has it. */
function writtenOf(value: unknown): string {
  if (typeof value === 'boolean') return value ? 'on' : 'off';
  if (Array.isArray(value)) return value.join(',');
  if (typeof value !== 'object' || value === null) return String(value);
  const given = Object.entries(value).filter(([, own]) => own !== undefined);
  return given.map(([name, own]) => `${name}=${writtenOf(own)}`).join(',') || 'on';
}

function parsed(name: string, value: unknown): unknown {
  const row = (rows as Record<string, Row<unknown> | undefined>)[name];
  if (!row) throw new BadOption({ what: 'no-option', option: name });
  try {
    return row.parse(writtenOf(value));
  } catch (error) {
    if (!(error instanceof BadValue)) throw error;
    // True and false as the program wrote them.
    const told = typeof value === 'boolean' ? String(value) : writtenOf(value);
    throw new BadOption({ what: 'value', option: name, value: told, ...error.fault });
  }
}

/** The options that make sheets look so: the inverse of `printOptions`, but for what was measured. */
export function lookOptions(print: PrintOptions): Options {
  const { assembly, duplex, lines, flatFold, foldAngles, foldTicks, legend, machine, dpi } = print;
  const { texture, colour, shading, flapBleed, thickness } = print;
  const dash = (kind: 'mountain' | 'valley'): string => {
    const lengths = lines[kind]?.dash;
    if (!lengths) return 'style';
    return lengths.length > 0 ? lengths.join(',') : 'solid';
  };
  return {
    style: print.style,
    cutWidth: lines.cut?.width ?? 'style',
    cutColour: lines.cut?.colour ?? 'style',
    mountainWidth: lines.mountain?.width ?? 'style',
    mountainDash: dash('mountain'),
    mountainColour: lines.mountain?.colour ?? 'style',
    valleyWidth: lines.valley?.width ?? 'style',
    valleyDash: dash('valley'),
    valleyColour: lines.valley?.colour ?? 'style',
    flapColour: print.flaps ?? 'style',
    flatFold,
    foldTicks: foldTicks ? 'on' : 'off',
    duplex: duplex ? 'on' : 'off',
    foldAngles: foldAngles ? 'on' : 'off',
    thickness: thickness === 0 ? 'off' : thickness,
    legend: legend ? 'on' : 'off',
    assembly: assembly ? 'on' : 'off',
    machine,
    dpi,
    texture,
    colour,
    shading: shading ? 'on' : 'off',
    flapBleed,
  };
}

/** Whether sheets look the same by two settings. */
export function isSameLook(one: Settings, other: Settings): boolean {
  return JSON.stringify(printOptions(one)) === JSON.stringify(printOptions(other));
}

/** Settings when nothing is asked for. */
export function defaultSettings(): Settings {
  const entries = Object.entries<Row<unknown>>(rows).map(([name, { parse, fallback }]) => [
    name,
    parse(fallback),
  ]);
  return Object.fromEntries(entries) as Settings;
}

/**
 * Settings with some changed. A size takes the place of the one before.
 *
 * @param allowed names of the options that may be given; all without it
 * @throws BadOption
 */
export function changedSettings(
  before: Settings,
  options: Readonly<Record<string, unknown>>,
  allowed?: ReadonlySet<string>,
): Settings {
  const given = new Map<string, unknown>();
  for (const [key, value] of Object.entries(options)) {
    if (value === undefined) continue;
    const name = nameOf(key);
    if (allowed && !allowed.has(name) && name in rows) {
      throw new BadOption({ what: 'fixed', option: name });
    }
    given.set(name, parsed(name, value));
  }
  const sizes = sizings.filter((name) => given.has(name) && given.get(name) !== 'none');
  if (sizes.length > 1) {
    throw new BadOption({ what: 'second-size', option: sizes[1]!, first: sizes[0]! });
  }
  const settings = { ...before };
  if (sizes.length === 1) for (const name of sizings) settings[name] = 'none';
  Object.assign(settings, Object.fromEntries(given));
  if (2 * settings.margin >= settings.paper.width) {
    const { margin, paper } = settings;
    throw new BadOption({
      what: 'no-paper-left',
      option: 'margin',
      margin_mm: margin,
      paper: paper.name,
    });
  }
  return settings;
}
