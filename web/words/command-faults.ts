/** Why a command line makes no sense. */
export type UsageFault =
  | { what: 'unknown-option'; option: string; similar: readonly string[] }
  | { what: 'no-argument'; argument: string }
  | { what: 'no-value'; option: string }
  | { what: 'too-many'; wanted: number; given: number }
  /** In words of the parser's own, which are English. */
  | { what: 'other'; text: string };
