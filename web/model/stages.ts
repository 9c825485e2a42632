/** The stages of a job in their order: the list that all others come from. */
export const stages = [
  { name: 'read', line: 'reading the model', words: 'Reading the model' },
  {
    name: 'learn',
    line: 'learning from unfoldings',
    words: 'Learning which faces unfold well together',
  },
  { name: 'cluster', line: 'cutting into parts', words: 'Choosing the parts' },
  { name: 'search', line: 'searching nets', words: 'Laying the parts flat' },
  { name: 'compact', line: 'making room for flaps', words: 'Making room for flaps' },
  { name: 'paper', line: 'placing on sheets', words: 'Placing the pieces on sheets' },
] as const satisfies readonly {
  /** As the engine names it. */
  name: string;
  /** What the command line says. */
  line: string;
  /** What the studio says. */
  words: string;
}[];

export type Stage = (typeof stages)[number]['name'];

/** Makes something for every stage. */
export function byStage<Value>(
  make: (stage: (typeof stages)[number]) => Value,
): Record<Stage, Value> {
  const entries = stages.map((stage) => [stage.name, make(stage)]);
  return Object.fromEntries(entries) as Record<Stage, Value>;
}
