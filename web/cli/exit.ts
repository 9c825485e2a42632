/** Exit statuses; part of the command line's contract. */
export const exitStatus = {
  done: 0,
  internal: 1,
  usage: 2,
  model: 3,
  cancelled: 4,
} as const;

/** Ends the program with a status and one line on stderr. */
export class Exit extends Error {
  constructor(
    readonly status: number,
    sentence: string,
  ) {
    // Whatever a file's name or an engine's message contains, it stays one line.
    super(sentence.replace(/\s*[\r\n]+\s*/g, ' '));
  }
}

/** The command line cannot be done as it stands. */
export function usageError(sentence: string): Exit {
  return new Exit(exitStatus.usage, `foldwright: ${sentence}`);
}
