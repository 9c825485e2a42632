import type { ValueFault } from '../model/option-values.js';

/** What is wrong with a step of the repair that an option names. */
export type StepFault = Extract<ValueFault, { expected: 'switches' | 'other-step' }>;
