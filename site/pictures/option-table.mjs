// The option table of the command with its help, from the sources that `--help` is made of.
import { fromSources } from './from-sources.mjs';

const entry = `
  export { rows } from './web/model/options.js';
  export { optionHelp } from './web/words/en/option-help.js';
  export { paperOptions, printOptionNames } from './web/api/written-options.js';
`;

/**
 * @typedef {{ name: string, value: string, fallback: string, help: string, group: string }} OptionRow
 * @returns {Promise<OptionRow[]>} `group`: what an option decides, `nets`, `paper` or `lines`
 */
export async function optionTable() {
  const { rows, optionHelp, paperOptions, printOptionNames } = await fromSources(entry);
  const groupOf = (name) => {
    if (printOptionNames.has(name)) return 'lines';
    return paperOptions.has(name) ? 'paper' : 'nets';
  };
  return Object.entries(rows).map(([name, { value, fallback }]) => ({
    name,
    value,
    fallback,
    help: optionHelp[name],
    group: groupOf(name),
  }));
}
