/** What Commander says in English, in other languages. */
import type { CommanderError, HelpConfiguration } from 'commander';
import type { UsageFault } from '../words/command-faults.js';
import type { Words } from '../words/words.js';

/** Help with its titles and defaults in a language. */
export function helpIn({ command }: Words): HelpConfiguration {
  const { titles } = command;
  const told: Readonly<Record<string, string>> = {
    'Usage:': titles.usage,
    'Arguments:': titles.arguments,
    'Options:': titles.options,
  };
  return {
    styleTitle: (title) => told[title] ?? title,
    optionDescription: ({ description, defaultValueDescription: value }) =>
      value === undefined ? description : command.withDefault(description, value),
  };
}

/** What stands between quotes in a message. */
function quotedIn(message: string): string {
  return /'([^']*)'/.exec(message)?.[1] ?? '';
}

/** Why Commander refuses a command line, which it says in a sentence and a code. */
export function usageFaultOf({ code, message }: CommanderError): UsageFault {
  switch (code) {
    case 'commander.unknownOption': {
      const similar = /\(Did you mean (?:one of )?(.*)\?\)/.exec(message)?.[1];
      return {
        what: 'unknown-option',
        option: quotedIn(message),
        similar: similar?.split(', ') ?? [],
      };
    }
    case 'commander.missingArgument':
      return { what: 'no-argument', argument: quotedIn(message) };
    case 'commander.optionMissingArgument':
      return { what: 'no-value', option: quotedIn(message) };
    case 'commander.excessArguments': {
      const [wanted = 0, given = 0] = (message.match(/\d+/g) ?? []).map(Number);
      return { what: 'too-many', wanted, given };
    }
    default:
      return { what: 'other', text: message.replace(/^error: /, '') };
  }
}
