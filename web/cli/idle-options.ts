/** Options that were given and that nothing reads, because of what others say. */
import type { ExportFormat } from '../export/formats.js';
import type { Settings } from '../model/options.js';
import type { Words } from '../words/words.js';
import type { Told } from './exit.js';

interface Need {
  /** What the option is about, in the words of the command line. */
  without: Told;
  /** Whether something reads it. */
  isMet: (settings: Settings, formats: readonly ExportFormat[]) => boolean;
}

const needsScale: Need = {
  without: ({ command }) => command.needs.scale,
  isMet: ({ scale }) => scale !== 'none',
};
const needsFlaps: Need = {
  without: ({ command }) => command.needs.flaps,
  isMet: (all) => all.flaps !== 'none' || all['flap-borders'] === 'on',
};
const needsFolding: Need = {
  without: ({ command }) => command.needs.folding,
  isMet: ({ folding }) => folding !== 'off',
};
const needsScissors: Need = {
  without: ({ command }) => command.needs.scissors,
  isMet: ({ machine }) => machine === 'none',
};

const needsPrinter: Need = {
  without: ({ command }) => command.needs.printer,
  isMet: ({ machine }) => machine === 'none' || machine === 'silhouette',
};

/** An output in one of these formats. */
function needsOutput(...formats: readonly ExportFormat[]): Need {
  const names = formats.map((format) => format.toUpperCase());
  return {
    without: ({ command }) => command.needs.output(names),
    isMet: (_, written) => formats.some((format) => written.includes(format)),
  };
}

const needs: Partial<Record<keyof Settings, Need[]>> = {
  unit: [needsScale],
  'flap-angle': [needsFlaps],
  'flap-style': [needsFlaps],
  'flap-side': [needsFlaps],
  'flap-colour': [needsFlaps, needsScissors],
  clearance: [needsFolding],
  style: [needsScissors],
  legend: [needsScissors],
  measured: [needsScissors],
  'fold-ticks': [needsScissors],
  thickness: [needsFlaps],
  duplex: [needsScissors, needsOutput('pdf')],
  assembly: [needsOutput('pdf', 'svg', 'png')],
  dpi: [needsOutput('png', 'svg', 'pdf')],
  texture: [needsPrinter, needsOutput('svg', 'pdf', 'png')],
  colour: [needsScissors, needsOutput('svg', 'pdf', 'png')],
  shading: [needsPrinter, needsOutput('svg', 'pdf', 'png')],
  'flap-bleed': [needsFlaps, needsPrinter],
};

/**
 * One phrase for each of the given options that changes nothing; none if all do.
 *
 * @param formats those of all outputs
 */
export function idleOptions(
  words: Words,
  given: ReadonlySet<string>,
  settings: Settings,
  formats: readonly ExportFormat[],
): string[] {
  return Object.entries(needs).flatMap(([name, all]) => {
    if (!given.has(name)) return [];
    const missing = all.find(({ isMet }) => !isMet(settings, formats));
    return missing ? [words.command.idle(name, missing.without(words))] : [];
  });
}
