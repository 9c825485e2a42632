/** Options that were given and that nothing reads, because of what others say. */
import type { ExportFormat } from '../export/formats.js';
import type { Settings } from '../model/options.js';

interface Need {
  /** What the option is about, in the words of the command line. */
  without: string;
  /** Whether something reads it. */
  isMet: (settings: Settings, formats: readonly ExportFormat[]) => boolean;
}

const needsScale: Need = { without: "'--scale'", isMet: ({ scale }) => scale !== 'none' };
const needsFlaps: Need = {
  without: 'flaps',
  isMet: (all) => all.flaps !== 'none' || all['flap-borders'] === 'on',
};
const needsFolding: Need = { without: 'folding', isMet: ({ folding }) => folding !== 'off' };
const needsScissors: Need = {
  without: "'--machine none'",
  isMet: ({ machine }) => machine === 'none',
};

const needsPrinter: Need = {
  without: "'--machine none' or '--machine silhouette'",
  isMet: ({ machine }) => machine === 'none' || machine === 'silhouette',
};

/** An output in one of these formats. */
function needsOutput(...formats: readonly ExportFormat[]): Need {
  const names = formats.map((format) => format.toUpperCase());
  const last = names.pop()!;
  const words = names.length > 0 ? `${names.join(', ')} or ${last}` : last;
  return {
    without: `a ${words} file`,
    isMet: (_, written) => formats.some((format) => written.includes(format)),
  };
}

const needs: Partial<Record<keyof Settings, Need[]>> = {
  unit: [needsScale],
  'flap-angle': [needsFlaps],
  'flap-side': [needsFlaps],
  'flap-colour': [needsFlaps, needsScissors],
  clearance: [needsFolding],
  style: [needsScissors],
  legend: [needsScissors],
  measured: [needsScissors],
  'fold-ticks': [needsScissors],
  duplex: [needsScissors, needsOutput('pdf')],
  assembly: [needsOutput('pdf', 'svg', 'png')],
  dpi: [needsOutput('png', 'svg', 'pdf')],
  texture: [needsPrinter, needsOutput('svg', 'pdf', 'png')],
  colour: [needsScissors, needsOutput('svg', 'pdf', 'png')],
  'flap-bleed': [needsFlaps, needsPrinter],
};

/**
 * One phrase for each of the given options that changes nothing; none if all do.
 *
 * @param formats those of all outputs
 */
export function idleOptions(
  given: ReadonlySet<string>,
  settings: Settings,
  formats: readonly ExportFormat[],
): string[] {
  return Object.entries(needs).flatMap(([name, all]) => {
    if (!given.has(name)) return [];
    const missing = all.find(({ isMet }) => !isMet(settings, formats));
    return missing ? [`option '--${name}' changes nothing without ${missing.without}`] : [];
  });
}
