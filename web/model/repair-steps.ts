/** The steps by which a file becomes a surface that can be unfolded. */

/**
 * What decides whether a step is done, in the order in which they run: 'switch': it is done unless it is switched
 * off; 'request': where an option of its own asks for it; 'always': unfolding needs it. As in
 * `cpp/repair/repair_steps.h`.
 */
export const repairSteps = {
  weld: 'switch',
  polygons: 'always',
  degenerate: 'always',
  duplicates: 'switch',
  'two-sided': 'switch',
  't-junctions': 'switch',
  cracks: 'switch',
  holes: 'request',
  winding: 'switch',
  'non-manifold': 'always',
  crossing: 'request',
  inside: 'request',
  flatten: 'switch',
} as const;

type StepName = keyof typeof repairSteps;

type StepsOf<Kind> = {
  [Name in StepName]: (typeof repairSteps)[Name] extends Kind ? Name : never;
}[StepName];

/** A step that can be switched off. */
export type RepairStep = StepsOf<'switch'>;
/** A step without which nothing can be unfolded. */
export type NeededStep = StepsOf<'always'>;
/** A step that an option of its own asks for. */
export type RequestedStep = StepsOf<'request'>;

/** The command line's options that ask for these steps. */
export const requests: Readonly<Record<RequestedStep, 'fill-holes' | 'crossing' | 'inside'>> = {
  holes: 'fill-holes',
  crossing: 'crossing',
  inside: 'inside',
};

/** Under which code the engine tells what a step did. */
export const repairCodes: Readonly<Record<RepairStep, string>> = {
  weld: 'welded-vertices',
  duplicates: 'dropped-duplicate-faces',
  'two-sided': 'merged-two-sided',
  't-junctions': 'closed-t-junctions',
  cracks: 'closed-cracks',
  winding: 'flipped-faces',
  flatten: 'flattened-faces',
};

/** Under which code the engine tells what a step would do that is switched off; its parameter `what` is the step. */
export const stepOff = 'step-off';

export const isStep = (name: string): name is StepName => Object.hasOwn(repairSteps, name);
export const isSwitch = (name: string): name is RepairStep => Object.hasOwn(repairCodes, name);
export const isRequested = (name: string): name is RequestedStep => Object.hasOwn(requests, name);

/** The steps that can be switched off, in the order in which they run. */
export const switchableSteps: readonly RepairStep[] = Object.keys(repairSteps).filter(isSwitch);

/** Steps that are switched off as a person writes them: 'weld=off,cracks=off', or 'on' for none. */
export function writtenRepair(off: readonly RepairStep[]): string {
  return off.length === 0 ? 'on' : off.map((step) => `${step}=off`).join(',');
}
