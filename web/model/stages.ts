/** The stages of a job in their order, as the engine names them: the list that all others come from. */
export const stages = ['read', 'learn', 'cluster', 'search', 'compact', 'paper'] as const;

export type Stage = (typeof stages)[number];

/** Makes something for every stage. */
export function byStage<Value>(make: (stage: Stage) => Value): Record<Stage, Value> {
  const entries = stages.map((stage) => [stage, make(stage)]);
  return Object.fromEntries(entries) as Record<Stage, Value>;
}
