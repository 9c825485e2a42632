/** Options that were given and that nothing reads, because of what others say. */
import type { Settings } from '../model/options.js';

interface Need {
  /** What the option is about, in the words of the command line. */
  without: string;
  /** Whether something reads it. */
  isMet: (settings: Settings) => boolean;
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

const needs: Partial<Record<keyof Settings, Need[]>> = {
  unit: [needsScale],
  'flap-angle': [needsFlaps],
  'flap-side': [needsFlaps],
  'flap-colour': [needsFlaps, needsScissors],
  clearance: [needsFolding],
  style: [needsScissors],
  legend: [needsScissors],
  measured: [needsScissors],
};

/** One phrase for each of the given options that changes nothing; none if all do. */
export function idleOptions(given: ReadonlySet<string>, settings: Settings): string[] {
  return Object.entries(needs).flatMap(([name, all]) => {
    if (!given.has(name)) return [];
    const missing = all.find(({ isMet }) => !isMet(settings));
    return missing ? [`option '--${name}' changes nothing without ${missing.without}`] : [];
  });
}
