/** What is said about a model before it is unfolded. */
import type { Settings } from '../model/options.js';
import { usualFaces } from '../model/face-numbers.js';
import type { Message } from '../model/message.js';
import { repairCodes, stepOff, switchableSteps, type RepairStep } from '../model/repair-steps.js';
import { phraseOf } from '../words/phrase.js';
import type { Words } from '../words/words.js';
import { sentence } from './sentence.js';

/** What stays wrong, so that a person should mend it elsewhere or know that pieces will collide. */
const unmended: readonly string[] = ['crossing-bodies', 'self-crossing-bodies'];

/** What stays as it is, and may well be meant. */
const left: readonly string[] = [
  'open-border',
  'flat-bodies',
  'huge-holes',
  'unfilled-holes',
  'crossings-unchecked',
];

/** What switches beside the lists are about. */
const switched: readonly string[] = ['open-holes', 'inner-bodies'];

/** Whether a message is about something wrong that nobody repairs. */
export function isUnmended({ code }: Message): boolean {
  return unmended.includes(code);
}

/** What was done to a model, or would have been. */
export interface RepairRow {
  /** Null for what cannot be switched off. */
  step: RepairStep | null;
  /** Empty where nothing is known of a step that is off. */
  words: string;
}

/** The step that a message is about, if it can be switched off. */
function stepOf({ code, params }: Message): RepairStep | null {
  const isOf = (step: RepairStep): boolean =>
    code === stepOff ? params['what'] === step : code === repairCodes[step];
  return switchableSteps.find(isOf) ?? null;
}

/** What was repaired, with all steps that are off, and sentences about what was not. */
export function repairWords(
  words: Words,
  repairs: readonly Message[],
  off: readonly RepairStep[] = [],
): {
  repaired: RepairRow[];
  remaining: string[];
} {
  const remains = ({ code }: Message): boolean => unmended.includes(code) || left.includes(code);
  const isSwitched = ({ code, params }: Message): boolean =>
    switched.includes(code) || Number(params['unitable']) > 0;
  const told = (message: Message): string => sentence(phraseOf(words, message));
  const listed = repairs.filter((repair) => !isSwitched(repair));
  const repaired = listed.filter((repair) => !remains(repair));
  const rows = repaired.map((repair) => ({ step: stepOf(repair), words: told(repair) }));
  const untold = off.filter((step) => !rows.some((row) => row.step === step));
  return {
    repaired: [...rows, ...untold.map((step) => ({ step, words: '' }))],
    remaining: listed.filter(remains).map(told),
  };
}

/** Why fewer triangles are proposed, or that none have to be. */
export function triangleWords({ check }: Words, faces: number, proposal: number | null): string {
  const has = check.triangles(faces);
  if (proposal !== null) return `${has} ${check.proposed(proposal)}`;
  return faces > usualFaces ? has : `${has} ${check.fine}`;
}

/** A number of triangles as it is asked for. */
export function wishWords({ check }: Words, wish: Settings['faces'], faces: number): string {
  return wish === 'off' || wish >= faces ? check.all(faces) : check.some(wish);
}

/** What the picture shows. */
export function lookWords(
  { check }: Words,
  faces: number | null,
  isWorking: boolean,
  wanted: string,
): string {
  if (isWorking) return check.making(wanted);
  return faces === null ? '' : check.shown(faces);
}

/** What there is to know of separate bodies; empty for one. */
export function bodyWords({ check }: Words, bodies: number, tiny: number): string {
  if (bodies < 2) return '';
  return tiny === 0 ? check.bodies(bodies) : `${check.bodies(bodies)} ${check.tiny(tiny)}`;
}
