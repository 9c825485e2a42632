import type { Preset } from '../app/options-form.js';

/** Attributes of a studio that fill in fields. */
export const presets = [
  'parts',
  'seed',
  'paper',
  'faces',
] as const satisfies readonly (keyof Preset)[];

/** Attributes of a studio that are texts, beside `lang`, which every element has. */
export type StudioTextAttribute = 'src' | 'options' | 'workers' | (typeof presets)[number];

/** Attributes of a studio that are there or not. */
export type StudioSwitchAttribute = 'whole-page' | 'autosave';
